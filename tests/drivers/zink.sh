#!/usr/bin/env bash
# The self-test, a scene against the reference solver, steps with the sums of graphics cards and the window on a second driver:
# zink, Mesa's OpenGL over Vulkan, on lavapipe, its Vulkan for processors. It compiles kernels as drivers of graphics cards do:
# storage blocks and texels in any order, no fused passes. Exit code 77 without lavapipe.
# zink.sh FASCIA SCENES FOLDER TEST_SIM_GPU_METHODS
set -euo pipefail
fascia=$1 scenes=$2 folder=$3 tests=$4
icd=$(compgen -G '/usr/share/vulkan/icd.d/lvp_icd.*.json' | head -n 1) || { echo "lavapipe is not installed" && exit 77; }
mkdir -p "$folder/run"
chmod 700 "$folder/run"
# zink of Mesa 22.3 confuses uniforms that it has compiled into kernels, which it does on processors only.
export GALLIUM_DRIVER=zink LIBGL_ALWAYS_SOFTWARE=1 VK_ICD_FILENAMES=$icd ZINK_INLINE_UNIFORMS=0 XDG_RUNTIME_DIR=$folder/run

# About one of 800 starts dies in a thread in which zink of Mesa 22.3 compiles a kernel while another one does the same, with nothing but
# zink on its stack: a command that ends by a segmentation fault is run again, twice at most.
again() {
  local status=0 attempt
  for attempt in 1 2 3; do
    status=0
    "$@" || status=$?
    ((status == 139)) || break
    echo "attempt $attempt ended by a segmentation fault: $*" >&2
  done
  return $status
}

again "$fascia" info --device --context egl >"$folder/device.txt" || { cat "$folder/device.txt" && exit 1; }
grep -q 'renderer *zink' "$folder/device.txt"
for loads in ssbo texel; do
  again "$fascia" run "$scenes/liver.json" --steps 3 --quiet --context egl --loads $loads --error --stats "$folder/$loads.json" --hash \
    >"$folder/$loads.hash"
  error=$(sed -n 's/^  "error": \([^,]*\),*$/\1/p' "$folder/$loads.json")
  echo "liver, read by $loads: error $error"
  awk -v error="$error" 'BEGIN { exit !(error > 0 && error < 1e-3) }'
done
cmp "$folder/ssbo.hash" "$folder/texel.hash"
export FASCIA_TEST_CONTEXT=egl
again "$tests" "steps within the span of the corrections and the last step"
again xvfb-run -a -s '-screen 0 1280x800x24' "$fascia" "$scenes/cube.json" --steps 10 --stats "$folder/window.json"
grep -q '"renderer": "zink' "$folder/window.json"

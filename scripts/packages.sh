# Debian packages that fascia needs, and a function that installs the missing ones. Sourced by run.sh and test.sh.

build_packages=(g++ cmake ninja-build pkg-config libeigen3-dev libglfw3-dev libgl-dev libegl-dev libimgui-dev libcli11-dev
  nlohmann-json3-dev libstb-dev libtinyobjloader-dev zlib1g-dev)
# OSMesa and EGL are opened at run time; ffmpeg and gnuplot are child processes.
run_packages=(libgl1 libgl1-mesa-dri libegl1 libegl-mesa0 libosmesa6 ffmpeg gnuplot-nox fonts-dejavu-core)
# Without those from mesa-vulkan-drivers on, what they test is left out: a second driver, the figures of compilers for graphics chips, the
# program on a chip that executes nothing, the Python module, the formatting.
test_packages=(catch2 xvfb xauth xdotool mesa-vulkan-drivers libvulkan-dev glslang-tools libdrm-dev python3 pybind11-dev python3-dev
  python3-numpy clang-format)

install_missing() {
  local missing=() package
  for package in "$@"; do
    [ "$(dpkg-query -W -f='${db:Status-Abbrev}' "$package" 2>/dev/null)" = "ii " ] || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  if ! command -v apt-get >/dev/null; then
    echo "fascia: missing Debian packages: ${missing[*]}; this system has no apt-get, install their equivalents" >&2
    return 1
  fi
  local as_root=()
  [ "$(id -u)" -eq 0 ] || as_root=(sudo)
  echo "fascia: installing with apt-get: ${missing[*]}"
  "${as_root[@]}" apt-get update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

# Configures once and builds what changed; a build that is up to date takes a fraction of a second.
build_preset() {
  local preset=$1
  [ -f "build/$preset/build.ninja" ] || cmake --preset "$preset" >/dev/null
  echo "fascia: building build/$preset"
  cmake --build --preset "$preset"
}

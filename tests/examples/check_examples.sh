#!/usr/bin/env bash
# Runs the example programs in a folder and compares the numbers that they print with known values.
# Usage: check_examples.sh FOLDER [DATA]; DATA: the data folder that the library must have found.
set -euo pipefail
folder=$1
data=${2:-}
failed=0

run() {  # run NAME: its output goes to $output
  if ! output=$("$folder/$1" 2>&1); then
    echo "FAILED $1: $output"
    exit 1
  fi
  echo "== $1"
  echo "$output"
}

# near KEY COLUMN EXPECTED TOLERANCE: the number in that column, 1 is the first, of the line that begins with KEY.
near() {
  if ! awk -v key="$1" -v column="$2" -v expected="$3" -v tolerance="$4" '
      $1 == key { found = 1; d = $(column + 1) - expected; ok = $(column + 1) ~ /^[-+0-9.eE]+$/ && d <= tolerance && -d <= tolerance; value = $(column + 1) }
      END { if (!found) { print "no line " key; exit 1 } if (!ok) { print key " is " value "; expected " expected " +- " tolerance; exit 1 } }' <<<"$output"
  then
    failed=1
  fi
}
value() { awk -v key="$1" -v column="$2" '$1 == key { print $(column + 1) }' <<<"$output"; }

# n steps of implicit Euler fall g dt^2 n (n + 1) / 2. float32 has 7 digits.
run hello_cube
near time 1 1 1e-6
near drop 1 4.98675 2e-5
near speed 1 9.81 2e-4
near volume_ratio 1 1 2e-5
if [ -n "$data" ] && [[ $output != *"data in $data"$'\n'* ]]; then
  echo "hello_cube: expected data in $data"
  failed=1
fi

# 1 kg in equilibrium: the forces of grab and supports equal the weight. Newton's method ends at a residual of 1e-10.
run drag_vertex
near weight 1 9.81 1e-5
near carried 1 0 1e-5
near carried 2 9.81 1e-5
near carried 3 0 1e-5
near target 1 0.13 1e-6
near target 2 0.11 1e-6
near speed 1 0 1e-3  # at rest again
near left 1 0 1e-3   # it bulges under its weight

# The closed form is that of small strains e; the law is stiffer by 3/2 e, and e is 0.2 percent at most.
run own_mesh
near converged 1 1 0
near closed_form 1 0.24525 1e-5
near stretch 1 0.24525 0.0008
near stiffer 1 0.1962 0.0006

# One equilibrium has one force at both ends. The pull of the clamp's vertices is slightly uneven: 0.2 percent.
run measure_force
for percent in 5 10 20; do
  law=$(value stretch_$percent 4)
  near stretch_$percent 2 "$law" "$(awk -v f="$law" 'BEGIN { print 0.002 * f }')"
  near stretch_$percent 3 "-$law" "$(awk -v f="$law" 'BEGIN { print 0.002 * f }')"
done
near stretch_10 4 2.304 0.01  # E A s (s^2 - 1) / 2 at s = 1.1 is 2.31; the clamp's springs give by 2e-4
near weight 1 0.3924 1e-6
near weight 2 0.3924 1e-5

# The cube's edges at 0.1 m and 0.2 m are rows 32 and 64 of 64; after 6 steps they are 0.0572 m, 18.3 rows, lower.
if [ -x "$folder/inside_opengl" ]; then
  run inside_opengl
  near frame_0 1 32 0
  near frame_0 2 63 0
  near frame_6 1 14 0
  near frame_6 2 45 0
  near errors 1 0 0
else
  echo "inside_opengl was not built: CMake found no OpenGL and EGL"
fi
exit $failed

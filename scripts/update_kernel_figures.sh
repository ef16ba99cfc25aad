#!/usr/bin/env bash
# Renews the table of registers that compilers for graphics chips need for each kernel (tests/drivers/kernel_figures.csv), after a change of
# kernels that costs more and is worth it, or for a new version of Mesa. Prints the rows of docs/concepts/gpu.md.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/packages.sh
install_missing "${build_packages[@]}" "${run_packages[@]}" "${test_packages[@]}"
[ -f build/ci/build.ninja ] || cmake --preset ci >/dev/null
cmake --build --preset ci --target test_drivers
LP_NUM_THREADS=0 LIBGL_ALWAYS_SOFTWARE=1 build/ci/tests/test_drivers "[.renew]"
git diff --stat tests/drivers/kernel_figures.csv

#!/usr/bin/env bash
# Installs what is missing, builds with warnings as errors and runs every test but the slow ones. Arguments go to ctest (-L label, -R name);
# -L slow runs those that take long.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/packages.sh
install_missing "${build_packages[@]}" "${run_packages[@]}" "${test_packages[@]}"
build_preset ci
[ $# -gt 0 ] || set -- -LE slow
ctest --preset ci "$@"

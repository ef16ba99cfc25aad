#!/usr/bin/env bash
# Kills processes that write files at random moments, scripts/kill.sh [TIMES, 100], and counts old, new and half files.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/packages.sh
install_missing "${build_packages[@]}" "${run_packages[@]}" "${test_packages[@]}"
build_preset ci
FASCIA_KILLS=${1:-100} build/ci/tests/test_app_commands "[kill]"

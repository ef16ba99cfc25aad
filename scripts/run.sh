#!/usr/bin/env bash
# Installs what is missing, builds the release program and starts it with the given arguments.
# Without a display (and without arguments) it renders the default scene headless instead: fascia.png and fascia.mp4.
set -euo pipefail
started_in=$PWD
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/packages.sh
install_missing "${build_packages[@]}" "${run_packages[@]}"
build_preset release
fascia=$PWD/build/release/fascia

if [ $# -eq 0 ] && [ -z "${DISPLAY:-}" ] && [ -z "${WAYLAND_DISPLAY:-}" ]; then
  echo "fascia: no display; rendering the default scene to $PWD/fascia.png and $PWD/fascia.mp4 (4 s)"
  exec "$fascia" render --out fascia.png --video fascia.mp4 --time 4
fi
cd "$started_in"
exec "$fascia" "$@"

#!/usr/bin/env bash
# Makes the goldens of assets/check anew and says what changed; arguments go to fascia check (--only NAME). Look at every changed picture
# before committing it.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/packages.sh
[ -n "${FASCIA:-}" ] || build_preset release
exec "${FASCIA:-build/release/fascia}" check assets/check --update --context osmesa "$@"

#!/bin/sh
# Draws the pictures of the example gallery anew, assets/pictures/scenes/NAME.png, after one second of each shipped scene:
# update_thumbnails.sh [NAME...], all of them without a name. FASCIA names the program, build/release/fascia by default.
set -eu
cd "$(dirname "$0")/.."
mkdir -p assets/pictures/scenes
for name in ${*:-$(cd assets/scenes && ls ./*.json | sed 's,^\./,,; s,\.json$,,')}; do
  "${FASCIA:-build/release/fascia}" render "assets/scenes/$name.json" --time 1 --size 448x252 --quiet --out "assets/pictures/scenes/$name.png"
done

#!/bin/sh
# Renders the moving picture of README.md anew, assets/pictures/pull.webp: one grab pulls a lobe of the liver, in colors of the von Mises
# stress. FASCIA names the program, build/release/fascia by default. The window, the tutorial, the gallery and bench figures make the other
# pictures: scripts/tutorial.sh --update, scripts/update_thumbnails.sh, fascia bench figures.
set -eu
cd "$(dirname "$0")/.."
frames=$(mktemp -d)
trap 'rm -rf "$frames"' EXIT
"${FASCIA:-build/release/fascia}" render assets/scenes/liver.json --data-dir . --context osmesa --time 3.4 --fps 30 --size 640x360 --samples 16 \
  --grab "at=0.1,-0.01,0.03;translate=0.03,-0.05,0.04;start=0.6;duration=1;release=2.4;radius=0.02;smooth=true" \
  --set display.color=von_mises --set display.range=[0,8000] --quiet --video "$frames/%03d.png"
# The first half second, in which the liver sags from its rest shape, is left out, so that the end joins the beginning.
ffmpeg -v error -y -framerate 30 -start_number 15 -i "$frames/%03d.png" -c:v libwebp -quality 75 -loop 0 assets/pictures/pull.webp
ls -l assets/pictures/pull.webp

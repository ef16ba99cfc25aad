#!/usr/bin/env bash
# Runs the commands of docs/tutorial.md as printed, in an empty folder that looks like the root of the source tree to them: it has
# build/release/fascia and assets. With --update the pictures of the tutorial are renewed; look at them.
#   scripts/tutorial.sh [--update] [FOLDER]        FASCIA: the program, else build/release/fascia, built if it is not
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
root=$PWD update=
if [ "${1:-}" = --update ]; then
  update=1
  shift
fi
if [ -z "${FASCIA:-}" ]; then
  source scripts/packages.sh
  build_preset release
  FASCIA=$root/build/release/fascia
fi
program=$(realpath "$FASCIA")
folder=${1:-$(mktemp -d)}
rm -rf "$folder"
mkdir -p "$folder/build/release"
ln -s "$program" "$folder/build/release/fascia"
ln -s "$root/assets" "$folder/assets"
awk '/^```sh$/ {inside = 1; next} /^```$/ {inside = 0} inside' docs/tutorial.md > "$folder/tutorial.sh"
cd "$folder"
# The same renderer on every machine, and the shaders of this tree.
LIBGL_ALWAYS_SOFTWARE=1 FASCIA_DATA_DIR=$root bash -euv tutorial.sh
cd tutorial
for file in opened.png methods.png inside.png pull.csv pulled.vtu pull.mp4 session.mp4 report.xml failures/kidney.diff.png; do
  if [ ! -s "$file" ]; then
    echo "tutorial.sh: $folder/tutorial/$file was not made" >&2
    exit 1
  fi
done
if [ -n "$update" ]; then
  mkdir -p "$root/assets/pictures/tutorial"
  cp opened.png methods.png inside.png "$root/assets/pictures/tutorial/"
  cp failures/kidney.diff.png "$root/assets/pictures/tutorial/difference.png"
fi
echo "tutorial.sh: done in $folder"

#!/usr/bin/env bash
# Runs the commands of docs/tutorial.md as they stand there, in an empty folder. With --update its pictures are renewed; look at them.
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
folder=${1:-$(mktemp -d)}
rm -rf "$folder"
mkdir -p "$folder"
cp assets/meshes/kidney.obj "$folder/"
cp assets/check/cube_grab.fascia "$folder/session.fascia"
awk '/^```sh$/ {inside = 1; next} /^```$/ {inside = 0} inside' docs/tutorial.md > "$folder/tutorial.sh"
cd "$folder"
fascia() {
  echo "\$ fascia $*"
  case $1 in
    render | run | check) "$FASCIA" "$@" --context osmesa ;;
    *) "$FASCIA" "$@" ;;
  esac
}
export -f fascia
export FASCIA
bash -eu tutorial.sh
for file in opened.png methods.png inside.png pull.csv pulled.vtu pull.mp4 session.mp4 report.xml failures/kidney.diff.png; do
  if [ ! -s "$file" ]; then
    echo "tutorial.sh: $folder/$file was not made" >&2
    exit 1
  fi
done
if [ -n "$update" ]; then
  mkdir -p "$root/assets/pictures/tutorial"
  cp opened.png methods.png inside.png "$root/assets/pictures/tutorial/"
  cp failures/kidney.diff.png "$root/assets/pictures/tutorial/difference.png"
fi
echo "tutorial.sh: done in $folder"

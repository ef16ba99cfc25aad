#!/usr/bin/env bash
# Renders the golden pictures of tests/app/test_golden.cpp anew. Look at every changed picture before committing it.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/packages.sh
[ -n "${FASCIA:-}" ] || build_preset release
fascia=${FASCIA:-build/release/fascia}
render() {
  local name=$1 scene=$2
  shift 2
  "$fascia" render "assets/scenes/$scene" --context osmesa --size 320x240 --quiet --out "tests/golden/$name.png" "$@"
  echo "tests/golden/$name.png"
}
mkdir -p tests/golden
render liver liver.json --steps 30
render beam_wireframe beam.json --steps 30 --wireframe
render ligament_stress ligament.json --steps 30 --color von_mises
render inclusion_strain inclusion.json --steps 30 --color strain
render cube_panels cube.json --steps 30 --ui
render liver_section liver.json --steps 30 --color largest_stress --set display.section.normal=[0,0,1] --set display.background=white
render inclusion_tets inclusion.json --steps 30 --color region --set display.tets.shrink=0.8 --set display.section.normal=[0,0,1] \
  --set display.background=transparent
render cube_rest cube.json --steps 0 --samples 1

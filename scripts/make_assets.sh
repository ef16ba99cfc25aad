#!/bin/sh
# Makes the meshes and surfaces in assets/meshes anew from assets/meshes/src: make_assets.sh [NAME...], all of them without a name.
# The shipped files were made with gmsh 4.8.4 (Debian 12, package gmsh) and Python 3.11; other versions give other,
# equally valid meshes. Neither is needed to build, test or run fascia.
set -eu
meshes=$(cd "$(dirname "$0")/../assets/meshes" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$meshes"/src/* "$work"
cd "$work"
for name in ${*:-beam ligament liver inclusion cube kidney retractor knot}; do
  if [ ! -f "$name.geo" ]; then  # a surface, filled with tets by fascia
    python3 "$name.py" "$meshes/$name.obj"
    continue
  fi
  if [ -f "$name.py" ]; then python3 "$name.py" "$name.stl"; fi
  # Delaunay, then swaps and smoothing of every tet whose quality (ratio of radii) is below 0.7: no slivers remain.
  gmsh -3 "$name.geo" -algo del3d -setnumber Mesh.OptimizeThreshold 0.7 -format msh22 -bin -v 2 -nt 1 -o "$name.msh"
  mv "$name.msh" "$meshes/$name.msh"
done

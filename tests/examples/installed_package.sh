#!/usr/bin/env bash
# Installs the library into an empty prefix, moves that elsewhere, builds the examples from a copy in another folder with nothing but
# find_package(fascia), and runs them; then one of them with the flags of pkg-config.
# Usage: installed_package.sh SOURCE BUILD WORK; WORK is emptied first.
set -euo pipefail
source_dir=$1
build=$2
work=$3
cmake=${CMAKE:-cmake}
here=$(cd "$(dirname "$0")" && pwd)

rm -rf "$work"
mkdir -p "$work/elsewhere"
for component in library data; do
  "$cmake" --install "$build" --prefix "$work/first" --component $component >"$work/install_$component.log"
done
mv "$work/first" "$work/prefix"
cp "$source_dir"/examples/*.cpp "$source_dir"/examples/CMakeLists.txt "$work/elsewhere"
unset FASCIA_DATA_DIR

"$cmake" -S "$work/elsewhere" -B "$work/build" -DCMAKE_PREFIX_PATH="$work/prefix" -DCMAKE_BUILD_TYPE=Release >"$work/configure.log"
found=$(sed -n 's/^fascia_DIR:PATH=//p' "$work/build/CMakeCache.txt")
if [[ $found != "$work/prefix/"* ]]; then
  echo "found fascia in $found; expected it in $work/prefix"
  exit 1
fi
"$cmake" --build "$work/build" >"$work/build.log" || { cat "$work/build.log"; exit 1; }
"$here/check_examples.sh" "$work/build" "$work/prefix/share/fascia"

export PKG_CONFIG_PATH
PKG_CONFIG_PATH=$(dirname "$(find "$work/prefix" -name fascia.pc)")
# shellcheck disable=SC2046
"${CXX:-c++}" $(pkg-config --cflags fascia) "$work/elsewhere/hello_cube.cpp" $(pkg-config --libs fascia) -o "$work/hello_by_pkg_config"
LD_LIBRARY_PATH=$(pkg-config --variable=libdir fascia) "$work/hello_by_pkg_config" | grep '^drop 4.9867'

# Internal symbols are hidden.
library=$(find "$work/prefix" -name libfascia.so)
shown=$(nm -DC --defined-only "$library")
if grep -v 'fascia::api::' <<<"$shown"; then
  echo "$library shows names that are not public"
  exit 1
fi
grep -q 'fascia::api::Simulation::step' <<<"$shown"
echo "installed package: examples built and run, $(wc -l <<<"$shown") public symbols"

#!/usr/bin/env bash
# Fuzzes every reader of files: scripts/fuzz.sh [SECONDS for each, 60] [NAME...]. Prints a table; new inputs are kept in
# build/fuzz/corpus/NAME, and one that breaks a reader in build/fuzz/found/ (mend the reader, then keep it in tests/fuzz/crashes/NAME).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/packages.sh
install_missing "${build_packages[@]}" clang libclang-rt-dev
build_preset fuzz
seconds=${1:-60}
shift || true
names=("$@")
if [ ${#names[@]} -eq 0 ]; then
  for source in tests/fuzz/fuzz_*.cpp; do
    name=$(basename "$source" .cpp)
    names+=("${name#fuzz_}")
  done
fi

mkdir -p build/fuzz/found
broken=0
echo "| reader | executions | per second | coverage (edges) | features | corpus | result |"
echo "|---|---|---|---|---|---|---|"
for name in "${names[@]}"; do
  corpus=build/fuzz/corpus/$name log=build/fuzz/$name.log
  mkdir -p "$corpus"
  seeds=(tests/fuzz/corpus/"$name")
  [ -d "tests/fuzz/crashes/$name" ] && seeds+=(tests/fuzz/crashes/"$name")
  dictionary=tests/fuzz/dictionaries/$name.dict
  options=(-max_total_time="$seconds" -max_len=8192 -timeout=10 -rss_limit_mb=2048 -malloc_limit_mb=512 -print_final_stats=1)
  [ -f "$dictionary" ] && options+=(-dict="$dictionary")
  result=clean
  "build/fuzz/fuzz_$name" "${options[@]}" -artifact_prefix="build/fuzz/found/$name-" "$corpus" "${seeds[@]}" >"$log" 2>&1 || {
    result=$(sed -n 's/^SUMMARY: //p' "$log" | tail -1)
    broken=1
  }
  awk -v name="$name" -v result="$result" '
    /cov: / { for (i = 1; i < NF; ++i) { if ($i == "cov:") cov = $(i + 1); if ($i == "ft:") ft = $(i + 1)
                                         if ($i == "corp:") corpus = $(i + 1) } }
    /^stat::number_of_executed_units:/ { runs = $2 }
    /^stat::average_exec_per_sec:/ { rate = $2 }
    END { sub("/.*", "", corpus); printf "| %s | %d | %d | %d | %d | %d | %s |\n", name, runs, rate, cov, ft, corpus, result }' "$log"
done
exit $broken

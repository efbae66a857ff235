#!/bin/bash
# The same bits from every compiler, optimisation level and vector level: builds the force kernel, the methods and their
# determinism tests with each and compares them with the golden hashes. Takes minutes, so it is no part of ctest.
#   tests/same_bits.sh [COMPILER:TYPE ...]    default: g++ and clang++, each Release and Debug; absent compilers are told
# Builds in build/same_bits/. Leaves with 1 where any differs, or where nothing could be compared.
set -u
root=$(cd "$(dirname "$0")/.." && pwd)
builds=("$@")
[ ${#builds[@]} -gt 0 ] || builds=(g++:Release g++:Debug clang++:Release clang++:Debug)
compared=0 different=0

run_build() { # compiler, type, folder
  cmake -S "$root" -B "$3" -DCMAKE_BUILD_TYPE="$2" -DCMAKE_CXX_COMPILER="$1" &&
    cmake --build "$3" --parallel "$(nproc)" --target integrators_tests &&
    "$3/tests/integrators_tests" --gtest_filter='*GoldenHashes*:*Determinism*'
}

for build in "${builds[@]}"; do
  compiler=${build%%:*} type=${build##*:}
  if ! command -v "$compiler" > /dev/null; then
    echo "$compiler is not installed: left out"
    continue
  fi
  folder=$root/build/same_bits/$(basename "$compiler")-$type
  mkdir -p "$folder"
  echo -n "$compiler $type ... "
  if run_build "$compiler" "$type" "$folder" > "$folder/log" 2>&1; then
    echo "same bits at $(grep -c '  OK .*GoldenHashes' "$folder/log") vector levels, any number of threads, fused or not"
  else
    different=1
    echo "DIFFERENT or not built, see $folder/log:"
    grep -E "golden line|FAILED|error" "$folder/log" | head -5
  fi
  compared=$((compared + 1))
done
[ $compared -gt 0 ] && [ $different -eq 0 ]

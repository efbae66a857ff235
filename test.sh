#!/usr/bin/env bash
# All tests from one command: installs what is missing, builds once, optimised, and runs ctest.
#   ./test.sh            that, in about five minutes on two cores
#   ./test.sh --all      and then everything again with the address and undefined-behaviour sanitizers, and, where clang
#                        is installed, a minute of random scenes, logs, rows and command lines (libFuzzer)
set -euo pipefail
case ${1:-} in
  "" | --all) ;;
  *) echo "usage: ./test.sh [--all]     (found: $*)" >&2 && exit 2 ;;
esac
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")"
.ci/setup

presets=(release)
if [[ ${1:-} == --all ]]; then presets+=(asan); fi
failed=()
for preset in "${presets[@]}"; do
  .ci/build "$preset"
  ctest --preset "$preset" --parallel "$(nproc)" || failed+=("$preset")
done

# What is found stays in build/fuzz/found; an input that fails is written to build/fuzz, and belongs into tests/fuzz/corpus.
fuzz() {
  local kind seconds=15
  .ci/build fuzz fuzz_scene fuzz_log fuzz_rows fuzz_motion fuzz_arguments || return 1
  for kind in scene log rows motion arguments; do
    mkdir -p "build/fuzz/found/$kind"
    "build/fuzz/tests/fuzz_$kind" -max_total_time=$seconds -timeout=20 -close_fd_mask=3 -print_final_stats=1 \
      -artifact_prefix="build/fuzz/$kind-" "build/fuzz/found/$kind" "tests/fuzz/corpus/$kind" \
      >"build/fuzz/$kind.log" 2>&1 || { tail -n 40 "build/fuzz/$kind.log" >&2 && return 1; }
    echo "fuzz: $kind: $(sed -n 's/^stat::number_of_executed_units: *//p' "build/fuzz/$kind.log") inputs, none failed"
  done
}
if [[ ${1:-} == --all ]]; then
  if command -v clang++ >/dev/null; then
    fuzz || failed+=(fuzz)
  else
    echo "fuzz: clang is not installed, so only what was found before was tried" >&2
  fi
fi

if ((${#failed[@]} > 0)); then
  echo "Tests failed in: ${failed[*]}" >&2
  exit 1
fi

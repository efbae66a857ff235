#!/usr/bin/env bash
# All tests from one command: installs what is missing, builds once, optimised, and runs ctest.
#   ./test.sh            that, in about five minutes on two cores
#   ./test.sh --all      and then everything again with the address and undefined-behaviour sanitizers
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
if ((${#failed[@]} > 0)); then
  echo "Tests failed in: ${failed[*]}" >&2
  exit 1
fi

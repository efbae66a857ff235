#!/usr/bin/env bash
# All tests from one command: installs what is missing, builds, runs ctest; first everything optimised, then the lowest
# rooms (core, integrators) with the address and undefined-behaviour sanitizers.
#   ./test.sh            that, in eight to ten minutes on two cores
#   ./test.sh --quick    the optimised build alone
#   ./test.sh --all      everything with the sanitizers too, the studies, the window and its panels included
set -euo pipefail
case ${1:-} in
  "" | --quick | --all) ;;
  *) echo "usage: ./test.sh [--quick | --all]     (found: $*)" >&2 && exit 2 ;;
esac
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")"
.ci/setup

failed=()
.ci/build release
ctest --preset release --parallel "$(nproc)" || failed+=(release)
if [[ ${1:-} == --all ]]; then
  .ci/build asan
  ctest --preset asan --parallel "$(nproc)" || failed+=(asan)
elif [[ ${1:-} != --quick ]]; then
  .ci/build asan lowest_rooms
  ctest --preset asan --parallel "$(nproc)" --tests-regex '^(core|integrators)\.' --no-tests=error || failed+=(asan)
fi
if ((${#failed[@]} > 0)); then
  echo "Tests failed in: ${failed[*]}" >&2
  exit 1
fi

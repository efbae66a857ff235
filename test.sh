#!/usr/bin/env bash
# All tests from one command: installs what is missing, builds, runs ctest; first optimised, then with the address and
# undefined-behaviour sanitizers.
#   ./test.sh            both
#   ./test.sh --quick    the optimised build alone
set -euo pipefail
case ${1:-} in
  "" | --quick) ;;
  *) echo "usage: ./test.sh [--quick]     (found: $*)" >&2 && exit 2 ;;
esac
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")"
.ci/setup

failed=()
.ci/build release
ctest --preset release --parallel "$(nproc)" || failed+=(release)
if [[ ${1:-} != --quick ]]; then
  .ci/build asan
  ctest --preset asan --parallel "$(nproc)" || failed+=(asan)
fi
if ((${#failed[@]} > 0)); then
  echo "Tests failed in: ${failed[*]}" >&2
  exit 1
fi

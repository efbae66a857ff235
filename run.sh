#!/usr/bin/env bash
# Tyg from one command: installs what is missing, builds what has changed, starts the program with the given arguments.
#   ./run.sh                the window, with the built-in scene `curtain`
#   ./run.sh list           any command of tyg; ./run.sh --help names them
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
"$here/.ci/setup"
"$here/.ci/build" release tyg
exec "$here/build/release/tyg" "$@"

#!/usr/bin/env bash
# A cloth that the graphics card moves in the real window, while the window draws: what is done to it there replays on the
# processor to the same bits. Where there is no card, the processor must do all of it by itself.
#   tests/drive_card.sh TYG glfw|glut PYTHON
set -euo pipefail

tyg=$1 backend=$2 python=$3
limit=90 # seconds for everything, on a slow and busy machine
tests=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
source "$tests/driving.sh"

open_window curtain --window "$backend" --device gpu --integrator leapfrog --record "$record"
press space
until_true "space starts" later_than 0.1
click 640 360
until_true "a click pushes the cloth" pushed 1
press 2
until_true "the method changes on the way" uses symplectic-euler
until_true "it runs on" later_than "$sim_s + 0.1"
# The window's own close button: what the card has must come back before the window's OpenGL is gone.
"$python" "$tests/close_window.py" "$window"
code=0
wait "$viewer" || code=$?
viewer=
((code == 0)) || fail "it left with $code"
grep -q '^# precision = float' "$record" || fail "the record is not of a run in float"
"$tyg" run --replay "$record" >/dev/null || fail "the processor does not come to the same bits"
echo "$backend: what the card moves in the window replays on the processor to the same bits"

#!/usr/bin/env bash
# Uses the tools of the left button in the real window under Xvfb, by real keys, clicks and drags, and reads what they do
# from the window's log. In the end the record is replayed to the same bits.
#   tests/drive_tools.sh TYG glfw|glut
set -euo pipefail

tyg=$1 backend=$2
limit=200
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/driving.sh"

with_tool() { [[ $tool == "$1" ]]; }
holds() { [[ $held == "$1" ]]; }
holds_one() { ((held >= 0)); }
has_pins() { ((pins == $1)); }
has_cuts() { ((cuts == $1)); }
# drag_to X1 Y1 X2 Y2: the button stays down. It moves at once: a button that is held still pushes.
drag_to() {
  point "$1" "$2"
  xdotool mousedown 1 mousemove $(($1 + ($3 > $1 ? 6 : -6))) "$2"
  few_frames
  local part
  for part in 1 2 3 4; do xdotool mousemove $(($1 + ($3 - $1) * part / 4)) $(($2 + ($4 - $2) * part / 4)) && few_frames 1; done
}
let_go() { xdotool mouseup 1 && few_frames; }

open_window curtain --window "$backend" --record "$record"
with_tool hand || fail "the hand is not the tool at the start: $tool"
press F3
until_true "F3 takes the pin" with_tool pin
press F4
until_true "F4 takes the cut" with_tool cut
press F2
until_true "F2 takes the hand" with_tool hand
click 670 20
until_true "a click on the bar takes the pin" with_tool pin
is "$pushes == 0" || fail "a click on the bar pushes the cloth"

# The cloth lies flat in the window's middle, from (325, 315) on the left to (955, 271) on the right.
click 640 320
until_true "a click pins a particle" has_pins 3
pinned=$picked
click 640 320
until_true "a click on the pin frees it" has_pins 2
[[ $picked == "$pinned" ]] || fail "it freed $picked, not $pinned"
press ctrl+z
until_true "undo pins it again" has_pins 3
press ctrl+z
until_true "undo takes the pin back" has_pins 2

press F4
until_true "F4 takes the cut" with_tool cut
drag_to 290 330 990 320
has_cuts 0 || fail "it cuts before the release"
let_go
until_true "a drag across the cloth cuts it" has_cuts 1
press ctrl+z
until_true "undo mends the cut" has_cuts 0
press ctrl+y
until_true "redo cuts again" has_cuts 1

press F2
until_true "F2 takes the hand" with_tool hand
# A pinned corner is always where it was: it can be grabbed, moved, and stays where it is let go. That starts the cloth.
in_state waiting || fail "pins and cuts start the cloth"
drag_to 955 271 860 200
until_true "a drag grabs the corner" holds 19
read_log && now=$sim_s
until_true "time passes meanwhile, and the view glides to where the cloth will get to" \
  later_than "$(awk "BEGIN { print $now + 1.2 }")"
xdotool click 4
few_frames
let_go
until_true "the release lets it go" holds -1
is "$pushes == 0" || fail "a drag pushes"
[[ $alarm == ok ]] || fail "the alarm went"
click 860 200
until_true "a click pushes" pushed 1

# The button held still pushes on; another tool lets go of everything.
point 860 200
xdotool mousedown 1
until_true "the held button pushes" pushed 2
let_go
drag_to 860 200 892 141
until_true "the corner is grabbed again" holds_one
press F4
until_true "another tool lets go" holds -1
let_go

# Without a right button and without a wheel.
read_log && old_x=$eye_x old_y=$eye_y old_z=$eye_z uses=$cuts
xdotool keydown shift
drag_to 640 400 640 330
until_true "a drag with Shift comes nearer" eye_moved
let_go
xdotool keyup shift keydown ctrl
drag_to 640 400 700 400
let_go
xdotool keyup ctrl
read_log
[[ $cuts == "$uses" ]] || fail "looking around cuts the cloth"

press space
until_true "it pauses" in_state paused
press Escape
wait_for_end "Escape"
for kind in push grab release pin cut mend; do
  grep -q "^[0-9]*,$kind," "$record" || fail "the record misses: $kind"
done
"$tyg" run curtain --replay "$record" >/dev/null || fail "the record does not replay to the same bits"
echo "$backend: the tools do what the bar says"

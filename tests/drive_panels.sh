#!/usr/bin/env bash
# Drives the panels in the real window with real keys and clicks under Xvfb, and reads what they did from the log and the
# files. Places are those of a 1280x720 window with text of 18 pixels in DejaVu Sans.
#   tests/drive_panels.sh TYG
set -euo pipefail

tyg=$1 backend=glfw
limit=220 # seconds for everything, on a slow and busy machine
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/driving.sh"

# ImGui looks at a key once a frame: one that is up again by then was never down.
hold() {
  xdotool keydown "$1"
  few_frames
  xdotool keyup "$1"
  few_frames
}
has_step() { is "($dt - $1)^2 < 1e-18"; }
picks() {
  xdotool mousemove 640 640 click 1
  until_true "a click beside the cloth pushes" pushed $((pushes + 1))
  local middle=$picked
  press r
  until_true "R restarts" in_state waiting
  [[ $middle == "$1" ]]
}

open_window curtain --record "$record"
few_frames

press k
few_frames
click 150 212
until_true "a click on the step's slider makes the step smaller" step_below 0.002
small=$dt
[[ $pushes == 0 ]] || fail "a click on a panel pushed the cloth"
press ctrl+z
until_true "Ctrl+Z undoes it" has_step 0.002
press ctrl+y
until_true "Ctrl+Y does it again" has_step "$small"
press ctrl+z
until_true "and Ctrl+Z undoes it again" has_step 0.002
press ctrl+shift+z
until_true "Ctrl+Shift+Z does it again" has_step "$small"

# The last of the list of methods is xpbd; the wheel and the clicks on the list are the panel's alone.
read_log && old_x=$eye_x old_y=$eye_y old_z=$eye_z
click 240 173
for ((notch = 0; notch < 6; ++notch)); do xdotool mousemove 150 300 click 5; done
few_frames
click 150 220
eye_moved && fail "the wheel on a list moved the camera"
[[ $integrator != rk4 ]] || fail "the list of methods chose nothing"
click 182 122 # Reset
until_true "Reset goes back to the scene's own method" uses rk4
until_true "and step" has_step 0.002

# A click far from the cloth pushes the middle particle, whose number tells the size of the sheet.
picks 210 || fail "the middle of 20x20 particles is 210, not $picked"
point 170 507
xdotool click --repeat 2 --delay 50 1
few_frames
xdotool type --delay 150 10
few_frames
[[ $integrator == rk4 ]] || fail "a number typed into a field chose a method"
hold Return
picks 55 || fail "the middle of 10x10 particles is 55, not $picked: rows follow columns"
[[ $sim_s == 0 ]] || fail "another sheet does not start anew"

click 270 122
click 270 122
[[ -s curtain.toml && -s curtain-2.toml ]] || fail "Save wrote no file, or overwrote one"
"$tyg" run curtain.toml --json | grep -q '"columns": *10' || fail "the saved scene is not the one that was shown"

press o
few_frames
point 1050 400
xdotool click --repeat 4 --delay 100 5
few_frames 8
click 945 420
until_true "a click on a picture opens its scene" has_step 0.002
xdotool search --onlyvisible --name '^Tyg: Drop' >/dev/null || fail "the title is not that of the new scene"
press Escape
few_frames
read_log && [[ $state == waiting ]] || fail "Esc closed more than a panel"
press space
until_true "the sheet falls" later_than 0.1
press space
until_true "it pauses" in_state paused

# What is kept is done again to the same bits.
press y
few_frames
for ending in png toml csv; do [[ -s tyg-drop-1.$ending ]] || fail "Y kept no tyg-drop-1.$ending"; done
"$tyg" run --replay tyg-drop-1.csv >/dev/null || fail "the kept run does not replay to the same bits"
"$tyg" run tyg-drop-1.toml --replay tyg-drop-1.csv >/dev/null || fail "nor does it on the kept scene"

# What is recorded is the scene as it was edited.
point 170 507
xdotool click --repeat 2 --delay 50 1
few_frames
xdotool type --delay 150 12
few_frames
hold Return
until_true "another sheet waits at its start" in_state waiting
press space
until_true "the edited sheet falls" later_than 0.1
# What acts at once, the drag of the air, is part of the record.
click 240 426
read_log
in_state running || fail "a change of the drag stopped the cloth"
until_true "it falls on" later_than "$(awk "BEGIN { print $sim_s + 0.1 }")"

[[ ! -e $XDG_STATE_HOME/tyg/hints ]] || fail "hints were shown although there is a log"
press Escape
few_frames
press Escape
wait_for_end "Escape"
grep -q '^# columns = 12' "$record" || fail "the record is not that of the edited scene"
grep -q '^[0-9]*,world,world.drag,' "$record" || fail "the record misses the drag"
"$tyg" run --replay "$record" >/dev/null || fail "the record of an edited scene does not replay to the same bits"
echo "the panels do what is done to them"

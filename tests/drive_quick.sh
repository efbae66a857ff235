#!/usr/bin/env bash
# Quick hands at slow frames: all that happens between two frames acts, on the cloth, the camera and the panels; and F11.
#   tests/drive_quick.sh TYG glfw|glut
set -euo pipefail

tyg=$1 backend=$2
limit=80 # seconds for everything, on a slow and busy machine
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/driving.sh"

# at_once COMMAND...: a frame that lasts until the command has ended.
at_once() {
  kill -STOP "$viewer"
  "$@"
  kill -CONT "$viewer"
}
has_step() { is "($dt - $1)^2 < 1e-18"; }
is_large() { [[ $(xdotool getwindowgeometry --shell "$window" | sed -n 's/^WIDTH=//p;s/^HEIGHT=//p' | paste -sd x) == "$1" ]]; }

open_window curtain --window "$backend"
few_frames
for key in w d e; do
  read_log && old_x=$eye_x old_y=$eye_y old_z=$eye_z
  at_once xdotool key $key
  until_true "a tap of $key moves the eye" eye_moved
done
few_frames
read_log && old_x=$eye_x old_y=$eye_y old_z=$eye_z
few_frames
read_log && ! eye_moved || fail "the eye moves on after a tap"

at_once xdotool key k
few_frames
at_once xdotool mousemove --window "$window" 150 212 click 1
until_true "a click on the step's slider makes the step smaller" step_below 0.002
at_once xdotool mousemove --window "$window" 182 122 click 1 mousemove --window "$window" 640 300
until_true "a click on Reset takes it back, though the mouse has moved on" has_step 0.002
[[ $pushes == 0 ]] || fail "a click on a panel pushed the cloth"
press Escape
few_frames

# GLFW takes presses of one key within 20 ms for its repetition.
at_once xdotool key --delay 50 space space space
until_true "three taps start, pause and start it" in_state running
at_once xdotool mousemove --window "$window" 1180 560 click 1
until_true "a click pushes" pushed 1
press Escape
wait_for_end "Escape"

size=800x500
open_window curtain --window "$backend"
until_true "it has the size that was asked for" is_large 800x500
press F11
until_true "F11 takes all of the screen" is_large "$screen"
press space
until_true "it runs there" later_than 0.1
press F11
until_true "F11 goes back" is_large 800x500
press Escape
wait_for_end "Escape"
echo "$backend: quick hands lose nothing"

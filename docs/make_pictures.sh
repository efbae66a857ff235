#!/usr/bin/env bash
# Makes anew the pictures of the front page, of the first steps, of six scenes, of three studies and of exploding cloth,
# in docs/pictures:
#   ./docs/make_pictures.sh [path of tyg]
#   TYG_WINDOW_ONLY=1 ./docs/make_pictures.sh [path of tyg]      without scenes and studies
# The window is the real one, on a virtual screen, with real keys and clicks; it needs what tests/driving.sh needs, and
# ffmpeg. Panels are pictured by make_panel_pictures.sh, charts by the commands that their pages name.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
tyg=$(readlink -f "${1:-$here/../build/release/tyg}")
pictures=$here/pictures

# study PICTURE NAME ARGUMENTS...: a command that writes NAME into the folder that it is given.
study() {
  local folder
  folder=$(mktemp -d)
  "$tyg" "${@:3}" --out "$folder" >/dev/null
  mv "$folder/$2" "$pictures/$1"
  rm -r "$folder"
}
# Six scenes with wind and bodies, side by side.
world() {
  local folder each
  folder=$(mktemp -d)
  for each in ball,1.4 bridge,3 tablecloth,2.2 sail,3 storm,2.5 flag,3; do
    "$tyg" render "${each%,*}" --at "${each#*,}" --size 640x400 --out "$folder/${each%,*}.png" >/dev/null
  done
  ffmpeg -loglevel error -y -i "$folder/ball.png" -i "$folder/bridge.png" -i "$folder/tablecloth.png" \
    -i "$folder/sail.png" -i "$folder/storm.png" -i "$folder/flag.png" \
    -filter_complex "xstack=inputs=6:layout=0_0|w0_0|w0+w1_0|0_h0|w0_h0|w0+w1_h0" "$pictures/world.png"
  rm -r "$folder"
}
if [[ -z ${TYG_DRIVEN:-}${TYG_WINDOW_ONLY:-} ]]; then
  world
  study four-particles.png plot.png plot four-particles
  study stability-curtain.png stability.png stability curtain
  study diet-curtain.png overlay.png diet curtain --within 5%
  "$here/make_exploding_pictures.sh" "$tyg"
fi

backend=glfw limit=300
source "$here/../tests/driving.sh"
picture() {
  few_frames 8
  sleep 0.5 # for the frame to reach the screen
  ffmpeg -loglevel error -y -f x11grab -draw_mouse 0 -video_size "$screen" -i "$DISPLAY" -frames:v 1 "$pictures/$1.png"
}
# hold KEY WHAT CONDITION...: the key stays down until the condition holds.
hold() {
  xdotool keydown "$1"
  until_true "${@:2}"
  xdotool keyup "$1"
}
# move_right_to X: the eye, so that an arrow away from where it was is seen from its side.
move_right_to() { hold d "the eye is farther to the right" eye_right_of "$1"; }
eye_right_of() { is "$eye_x > $1"; }
# nearer NOTCHES: of the wheel.
nearer() {
  xdotool click --repeat "$1" --delay 100 4
  few_frames 6
}
# turn ACROSS DOWN: the view, by dragging the mouse over so many pixels.
turn() {
  point 640 300
  xdotool mousedown 3
  few_frames
  point $((640 + $1)) $((300 + $2))
  xdotool mouseup 3
}
leave() {
  xdotool key Escape
  wait_for_end "Escape"
}

cd "$work"
open_window curtain
picture start
xdotool mousemove 700 320
press space
until_true "it swings" later_than 0.55
xdotool mousedown 1
pushed_and_later() { ((pushes > 0)) && later_than "$1"; }
until_true "it is pushed" pushed_and_later 0.62
press space
until_true "it pauses" in_state paused
xdotool mouseup 1
click 730 290 # what is pushed while time is paused stays marked
nearer 2
move_right_to 2.3
turn -45 -15
picture window
leave

open_window curtain
press space
hold bracketright "the step comes close to its limit" step_past 0.0039
press space
until_true "it pauses" in_state paused
picture close
press space
hold bracketright "the step passes its limit" step_past 0.0043
until_true "the alarm freezes it" in_state frozen
picture failure
press v
until_true "it goes on" in_state running
until_true "it is past where it broke" later_than "$(awk "BEGIN { print $sim_s + 0.5 }")"
press space
until_true "it pauses" in_state paused
picture cured
leave

open_window curtain --integrator backward-euler --dt 0.01
press h
press g
press space
until_true "it swings" later_than 0.6
xdotool mousemove 560 240 mousedown 1
until_true "it is pushed" pushed_and_later 0.85
press space
until_true "it pauses" in_state paused
xdotool mouseup 1
few_frames 40 # the ghost catches up from the start
click 590 270
nearer 3
move_right_to 1.9
turn -20 -30 # the cloth to the left of the panel, and farther down
picture front
press g
leave

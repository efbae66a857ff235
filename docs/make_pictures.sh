#!/usr/bin/env bash
# Makes anew the pictures of the front page, of the first steps and of three studies, in docs/pictures:
#   ./docs/make_pictures.sh [path of tyg]
#   TYG_WINDOW_ONLY=1 ./docs/make_pictures.sh [path of tyg]      without the three studies
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
if [[ -z ${TYG_DRIVEN:-}${TYG_WINDOW_ONLY:-} ]]; then
  study four-particles.png plot.png plot four-particles
  study stability-curtain.png stability.png stability curtain
  study diet-curtain.png overlay.png diet curtain --within 5%
fi

backend=glfw limit=300
source "$here/../tests/driving.sh"
picture() {
  few_frames 8
  sleep 0.5 # for the frame to reach the screen
  ffmpeg -loglevel error -y -f x11grab -video_size "$screen" -i "$DISPLAY" -frames:v 1 "$pictures/$1.png"
}
# hold KEY WHAT CONDITION...: the key stays down until the condition holds.
hold() {
  xdotool keydown "$1"
  until_true "${@:2}"
  xdotool keyup "$1"
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
point 640 20
picture window
press space
hold bracketright "the step comes close to its limit" step_past 0.0039
press space
until_true "it pauses" in_state paused
picture close
press space
hold bracketright "the step passes its limit" step_past 0.0044
until_true "the alarm freezes it" in_state frozen
picture failure
press v
until_true "it goes on" in_state running
until_true "it is past where it broke" later_than "$(awk "BEGIN { print $sim_s + 0.5 }")"
press space
until_true "it pauses" in_state paused
picture cured
leave

open_window curtain --integrator report-rk4
press h
press space
until_true "it swings" later_than 0.5
xdotool mousemove 480 250 mousedown 1
until_true "it is pushed" pushed_and_later 0.8
press space
until_true "it pauses" in_state paused
xdotool mouseup 1
press g
few_frames 60 # the ghost catches up from the start
xdotool mousemove 530 330 click 4 click 4
point 640 20 # the panel takes its final size
picture front
press g
leave

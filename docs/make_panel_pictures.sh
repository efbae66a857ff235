#!/usr/bin/env bash
# Takes pictures of every panel in the real window at 1280x720 and 1920x1080, dark and light, for looking at, and the
# pictures of the panels in docs/pictures: ./docs/make_panel_pictures.sh [path of tyg [FOLDER]]
# FOLDER: build/panels, for PANEL-SIZE.png. On a virtual screen, with real keys and clicks; it needs what tests/driving.sh
# needs, and ffmpeg.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
tyg=$(readlink -f "${1:-$here/../build/release/tyg}")
folder=${2:-$here/../build/panels}
mkdir -p "$folder"
folder=$(readlink -f "$folder")

if [[ -z ${TYG_SCREEN:-} ]]; then
  for size in 1280x720 1920x1080; do TYG_SCREEN=$size "$here/make_panel_pictures.sh" "$tyg" "$folder"; done
  for name in laboratory chart energy; do cp "$folder/$name-1280x720.png" "$here/pictures/$name.png"; done
  exit
fi
screen=$TYG_SCREEN backend=glfw limit=900 turns=2400
source "$here/../tests/driving.sh"
width=${screen%x*} height=${screen#*x}

picture() {
  few_frames 8
  sleep 0.5 # for the frame to reach the screen
  ffmpeg -loglevel error -y -f x11grab -draw_mouse 0 -video_size "$screen" -i "$DISPLAY" -frames:v 1 "$folder/$1-$screen.png"
}
both() {
  picture "$1"
  press b
  picture "$1-light"
  press b
}
# From the start, pushed on the way, and paused.
run_a_while() {
  press r
  until_true "a restart" in_state waiting
  press space
  until_true "it swings" later_than 0.4
  xdotool mousemove --window "$window" $((width / 2)) $((height * 2 / 5)) click 1 mousemove $((width / 2)) $((height * 9 / 10))
  until_true "it is pushed" later_than 0.75
  press space
  until_true "it pauses" in_state paused
}

open_window curtain
for panel in control:k gallery:o ghost:g stretch:t energy:equal traces:slash; do # name:key
  press "${panel#*:}"
  run_a_while
  if [[ $panel == gallery:* ]]; then few_frames 60; fi # its pictures are drawn by and by
  both "${panel%:*}"
  press "${panel#*:}"
done

press k
press o
few_frames 60
picture laboratory
press k
for ((notch = 0; notch < 80; ++notch)); do xdotool mousemove $((width - 100)) $((height / 2)) click 5; done
picture gallery-end
press o

press c
sleep 120 # points come in
both chart
xdotool mousemove $((width - 400)) $((height / 4))
picture chart-hover
press c

press k
press r
press space
xdotool keydown bracketright
until_true "the step passes its limit" step_past 0.0044
xdotool keyup bracketright
until_true "the alarm freezes it" in_state frozen
few_frames
picture control-failure

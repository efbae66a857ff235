#!/usr/bin/env bash
# Opens the chart, the ghost, the stretch, the energy and the traces in the real window with real keys and clicks under
# Xvfb, and reads from the log what they did. Every state is waited for by polling.
#   tests/drive_studies.sh TYG [PICTURES [WIDTHxHEIGHT]]     with PICTURES, a folder: keeps a picture of each panel there
set -euo pipefail

tyg=$1 pictures=${2:-} screen=${3:-1280x720} backend=glfw
limit=240 turns=1200 # seconds for everything, on a slow and busy machine
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/driving.sh"

setting_changed() { [[ $integrator,$dt != "$before" ]]; }
# From now on for so many simulated seconds.
some_time() {
  look
  until_true "time passes" later_than "$(awk "BEGIN { print $sim_s + $1 }")"
}
# The window has to have drawn with the cursor there before it knows what is under it.
point_at() {
  xdotool mousemove --window "$window" "$1" "$2"
  few_frames 2
}
picture() {
  few_frames 6
  [[ -z $pictures ]] || ffmpeg -v error -y -f x11grab -video_size "$screen" -i "$DISPLAY" -frames:v 1 "$pictures/$1.png"
}
close_window() {
  press Escape
  wait_for_end "Escape"
}

if [[ -n $pictures ]]; then mkdir -p "$pictures"; fi
width=${screen%x*} height=${screen#*x}

# The chart of the smallest scene. A click on one of its points takes that point's method and step.
open_window four-particles
press c
few_frames
look && before=$integrator,$dt
adopted=
for ((turn = 0; turn < 400 && ${#adopted} == 0; ++turn)); do
  # Somewhere in the plot, where the rows come in one after the other.
  x=$((width - 30 * 18 + (turn * 37) % (24 * 18))) y=$((8 * 18 + (turn * 23) % (12 * 18)))
  point_at "$x" "$y"
  xdotool click 1
  few_frames 1
  if setting_changed; then adopted=yes; fi
done
[[ -n $adopted ]] || fail "no click on the chart takes a setting"
[[ $pushes == 0 ]] || fail "clicks on the chart push the cloth"
look
echo "chart: from $before to $integrator,$dt after $turn clicks"
point_at 300 "$((height - 200))"
few_frames 40 # of rows coming in
picture chart
press c
close_window

# The others on the curtain, poked.
open_window curtain
press g
press space
some_time 0.3
xdotool mousemove --window "$window" "$((width / 2))" "$((height * 2 / 5))" click 1
some_time 0.4
picture ghost
press r
until_true "a restart with a ghost" in_state waiting
press space
some_time 0.2
press g
for panel in t:stretch equal:energy slash:traces; do
  press "${panel%%:*}"
  some_time 0.5
  picture "${panel##*:}"
  press "${panel%%:*}"
  few_frames
done
press t
press g
some_time 0.2
press Escape # closes the panel opened last, and does not leave
press Escape
some_time 0.1
[[ $alarm == ok ]] || fail "the cloth failed"
close_window
echo "the panels that study: all good"

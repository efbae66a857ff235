#!/usr/bin/env bash
# Opens the chart, the ghost, the stretch, the energy and the traces in the real window with real keys and clicks under
# Xvfb, and reads from the log what they did. Every state is waited for by polling.
#   tests/drive_studies.sh TYG [PICTURES [WIDTHxHEIGHT]]     with PICTURES, a folder: keeps a picture of each panel there
set -euo pipefail

tyg=$1 pictures=${2:+$(readlink -m "$2")} screen=${3:-1280x720} backend=glfw
limit=240 turns=1200 # seconds for everything, on a slow and busy machine
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/driving.sh"

setting_changed() { [[ $integrator,$dt != "$before" ]]; }
# From now on for so many simulated seconds.
some_time() {
  read_log
  until_true "time passes" later_than "$(awk "BEGIN { print $sim_s + $1 }")"
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
read_log && before=$integrator,$dt
adopted=
for ((turn = 0; turn < 400 && ${#adopted} == 0; ++turn)); do
  # Somewhere in the plot, where the rows come in one after the other.
  x=$((width - 30 * 18 + (turn * 37) % (24 * 18))) y=$((8 * 18 + (turn * 23) % (12 * 18)))
  point "$x" "$y"
  xdotool click 1
  few_frames 1
  if setting_changed; then adopted=yes; fi
done
[[ -n $adopted ]] || fail "no click on the chart takes a setting"
[[ $pushes == 0 ]] || fail "clicks on the chart push the cloth"
read_log
echo "chart: from $before to $integrator,$dt after $turn clicks"
point 300 "$((height - 200))"
few_frames 40 # of rows coming in
picture chart
press c
close_window

# The others on the curtain, pushed.
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

# Another method beside it: the fifth line of the list, which then is the cloth's.
click "$((width - 220))" 91
click "$((width - 300))" 215
read_log && before=$sim_s
click "$((width - 300))" 122
until_true "the ghost's method is swapped with the cloth's" uses leapfrog
until_true "and both begin anew" earlier_than "$before"
few_frames
click "$((width - 300))" 122
until_true "and swapped back" uses rk4
press g

# A click on a plot goes back to its moment.
for panel in equal:energy slash:traces; do
  press "${panel%%:*}"
  some_time 0.8
  picture "${panel##*:}"
  press space
  until_true "it pauses" in_state paused
  newest=$sim_s
  click "$((width - 45))" 140
  until_true "a click on the plot of ${panel##*:} goes back" earlier_than "$newest"
  press space
  until_true "it goes on from there" in_state running
  press "${panel%%:*}"
  few_frames
done

# The stretch colours the springs: hardly any is as blue then as all are without it.
blue_places() {
  ffmpeg -v error -f x11grab -video_size "$((width / 3))x$((height / 2))" -i "$DISPLAY+$((width / 3)),$((height / 5))" \
    -frames:v 1 -f rawvideo -pix_fmt rgb24 - | od -An -v -tu1 -w3 | awk '$3 > 120 && $3 > $1 + 40 { ++count } END { print count + 0 }'
}
if command -v ffmpeg >/dev/null; then
  few_frames
  plain=$(blue_places)
  press t
  few_frames
  coloured=$(blue_places)
  is "$plain > 200 && $coloured < $plain / 2" || fail "stretch colours nothing: $plain blue places before, $coloured with it"
  press t
fi
press t
some_time 0.5
picture stretch

# Where a panel stands it takes the clicks; closed, it does not.
for key in t g equal slash; do
  press "$key"
  few_frames
  read_log && before=$pushes
  open=1
  point "$((width - 300))" 57
  xdotool click 1 # quickly: what is held longer beside the cloth is no click
  few_frames
  [[ $key != t ]] || open=0 # it was open
  ((pushes == before + 1 - open)) || fail "the panel of key $key takes no clicks, or all"
  press "$key"
  few_frames
done
press g
some_time 0.2
press Escape # closes the panel opened last, and does not leave
press Escape
some_time 0.1
[[ $alarm == ok ]] || fail "the cloth failed"
close_window
echo "the panels that study: all good"

#!/usr/bin/env bash
# Opens the chart, the ghost, the stretch, the energy and the traces in the real window with real keys and clicks under
# Xvfb, and reads from the log what they did. Every state is waited for by polling.
#   tests/drive_studies.sh TYG [PICTURES [WIDTHxHEIGHT]]     with PICTURES, a folder: keeps a picture of each panel there
set -euo pipefail

tyg=$1 pictures=${2:-} size=${3:-1280x720}
limit=240 # seconds for everything, on a slow and busy machine

for tool in xvfb-run xauth xdotool; do
  command -v "$tool" >/dev/null || { echo "missing: $tool (.ci/setup installs it)" && exit 1; }
done
if [[ -z ${TYG_DRIVEN:-} ]]; then
  export TYG_DRIVEN=1
  exec timeout --kill-after=5 "$limit" xvfb-run -a -s "-screen 0 ${size}x24 -nolisten tcp" "$0" "$@"
fi

work=$(mktemp -d)
log=$work/view.csv
cleanup() {
  if [[ -n ${viewer:-} ]]; then kill "$viewer" 2>/dev/null || true; fi
  rm -rf "$work"
}
trap cleanup EXIT

fail() {
  echo "$*; the log ends with:"
  tail -n 3 "$log" || true
  exit 1
}

# The newest whole line of the log, as shell variables named after its columns.
look() {
  local line
  line=$(tail -n 2 "$log" 2>/dev/null | grep ',.*,.*,.*,.*,.*,.*,.*,.*,.*,.*,.*,' | grep -v '^frame' | tail -n 1) || return 1
  IFS=, read -r frame _ sim_s state integrator dt _ _ _ _ pushes _ alarm <<<"$line"
  [[ -n ${alarm:-} ]]
}
# until_true WHAT CONDITION...: polls until the condition, a command, holds for the newest line.
until_true() {
  local what=$1
  shift
  for ((turn = 0; turn < 1200; ++turn)); do
    kill -0 "$viewer" 2>/dev/null || fail "the viewer ended while waiting: $what"
    if look && "$@"; then return; fi
    sleep 0.05
  done
  fail "never happened: $what"
}
in_state() { [[ $state == "$1" ]]; }
later_than() { awk "BEGIN { exit !($sim_s > $1) }"; }
frames_since() { ((frame >= $1)); }
setting_changed() { [[ $integrator,$dt != "$before" ]]; }
press() { xdotool key --clearmodifiers "$1"; }
some_frames() {
  look
  until_true "more frames" frames_since "$((frame + ${1:-3}))"
}
# From now on for so many simulated seconds.
some_time() {
  look
  until_true "time passes" later_than "$(awk "BEGIN { print $sim_s + $1 }")"
}
# The window has to have drawn with the cursor there before it knows what is under it.
point_at() {
  xdotool mousemove --window "$window" "$1" "$2"
  some_frames 2
}
picture() {
  some_frames 6
  [[ -z $pictures ]] || ffmpeg -v error -y -f x11grab -video_size "$size" -i "$DISPLAY" -frames:v 1 "$pictures/$1.png"
}
open_scene() {
  : >"$log"
  "$tyg" view "$1" --size "$size" --log "$log" &
  viewer=$!
  until_true "it opens waiting" in_state waiting
  window=$(xdotool search --sync --onlyvisible --name '^Tyg' | head -n 1)
}
close_window() {
  press Escape
  for ((turn = 0; turn < 600; ++turn)); do
    if ! kill -0 "$viewer" 2>/dev/null; then
      wait "$viewer" || fail "the viewer failed at its end"
      viewer=
      return
    fi
    sleep 0.05
  done
  fail "Esc does not leave"
}

if [[ -n $pictures ]]; then mkdir -p "$pictures"; fi
width=${size%x*} height=${size#*x}

# The chart of the smallest scene. A click on one of its points takes that point's method and step.
open_scene four-particles
press c
some_frames
look && before=$integrator,$dt
adopted=
for ((turn = 0; turn < 400 && ${#adopted} == 0; ++turn)); do
  # Somewhere in the plot, where the rows come in one after the other.
  x=$((width - 30 * 18 + (turn * 37) % (24 * 18))) y=$((8 * 18 + (turn * 23) % (12 * 18)))
  point_at "$x" "$y"
  xdotool click 1
  some_frames 1
  if setting_changed; then adopted=yes; fi
done
[[ -n $adopted ]] || fail "no click on the chart takes a setting"
[[ $pushes == 0 ]] || fail "clicks on the chart push the cloth"
look
echo "chart: from $before to $integrator,$dt after $turn clicks"
point_at 300 "$((height - 200))"
some_frames 40 # of rows coming in
picture chart
press c
close_window

# The others on the curtain, poked.
open_scene curtain
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
  some_frames
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

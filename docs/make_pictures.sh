#!/usr/bin/env bash
# Makes the README's pictures anew from the built program: ./docs/make_pictures.sh [path of tyg]
# The window is the real one, on a virtual screen, with real keys and clicks; it needs xvfb, xdotool and ffmpeg.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
tyg=$(readlink -f "${1:-$here/../build/release/tyg}")
cd "$here"

if [[ ${TYG_PICTURES:-} != window ]]; then
  "$tyg" plot four-particles --out four-particles >/dev/null
  mv four-particles/plot.png four-particles.png
  rm -r four-particles
  "$tyg" stability curtain --out stability >/dev/null
  mv stability/stability.png stability-curtain.png
  rm -r stability
  "$tyg" diet curtain --within 5% --out diet >/dev/null
  mv diet/overlay.png diet-curtain.png
  rm -r diet
  TYG_PICTURES=window exec xvfb-run -a -s "-screen 0 1280x720x24 -nolisten tcp" "$here/make_pictures.sh" "$tyg"
fi

log=$(mktemp)
"$tyg" view curtain --log "$log" &
viewer=$!
trap 'kill "$viewer" 2>/dev/null || true; rm -f "$log"' EXIT
# wait_for CONDITION: polls the log's newest line, an awk condition over its columns ($3 sim_s, $4 state, $11 pushes).
wait_for() {
  for ((turn = 0; turn < 600; ++turn)); do
    if tail -n 1 "$log" | awk -F, "NF == 13 { found = ($1) } END { exit !found }"; then return; fi
    sleep 0.05
  done
  echo "make_pictures: never came to $1" >&2
  exit 1
}
picture() { ffmpeg -loglevel error -y -f x11grab -video_size 1280x720 -i "$DISPLAY" -frames:v 1 "$1"; }

wait_for '$4 == "waiting"'
xdotool mousemove 640 380 key space
wait_for '$3 > 0.55'
xdotool mousedown 1
wait_for '$11 > 0 && $3 > 0.62'
xdotool key space
wait_for '$4 == "paused"'
picture window.png
xdotool mouseup 1 mousemove 640 20 key space keydown bracketright
wait_for '$6 > 0.0044'
xdotool keyup bracketright
wait_for '$4 == "frozen"'
sleep 0.5 # for the frame to reach the screen
picture failure.png
xdotool key Escape
wait "$viewer"

#!/usr/bin/env bash
# Takes a picture of each panel in the real window at 1280x720 and 1920x1080, for looking at, and the README's picture of
# the laboratory: ./docs/make_panel_pictures.sh [path of tyg [FOLDER]]      (FOLDER: build/panels; PANEL-SIZE.png)
# On a virtual screen, with real keys and clicks; it needs xvfb, xdotool and ffmpeg.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
tyg=$(readlink -f "${1:-$here/../build/release/tyg}")
folder=${2:-$here/../build/panels}
mkdir -p "$folder"
folder=$(readlink -f "$folder")
panels=(control:k gallery:o) # name:key

if [[ -z ${TYG_SCREEN:-} ]]; then
  for size in 1280x720 1920x1080; do
    TYG_SCREEN=$size xvfb-run -a -s "-screen 0 ${size}x24 -nolisten tcp" "$here/make_panel_pictures.sh" "$tyg" "$folder"
  done
  cp "$folder/laboratory-1280x720.png" "$here/laboratory.png"
  exit
fi

size=$TYG_SCREEN
log=$(mktemp)
"$tyg" view curtain --size "$size" --log "$log" &
viewer=$!
trap 'kill "$viewer" 2>/dev/null || true; rm -f "$log"' EXIT
# wait_for CONDITION: polls the log's newest line, an awk condition over its columns ($1 frame, $3 sim_s, $4 state).
wait_for() {
  for ((turn = 0; turn < 1200; ++turn)); do
    if tail -n 1 "$log" | awk -F, "NF == 13 { found = ($1) } END { exit !found }"; then return; fi
    sleep 0.05
  done
  echo "make_panel_pictures: never came to $1" >&2
  exit 1
}
frames() { wait_for "\$1 > $(tail -n 1 "$log" | cut -d, -f1) + $1"; }
picture() {
  frames 60 # a panel finds its place, and what it draws in the background fills in
  sleep 0.5 # for the frame to reach the screen
  ffmpeg -loglevel error -y -f x11grab -video_size "$size" -i "$DISPLAY" -frames:v 1 "$folder/$1-$size.png"
}

wait_for '$4 == "waiting"'
xdotool mousemove $((${size%x*} / 2)) 20 key space
wait_for '$3 > 0.55'
xdotool key space
wait_for '$4 == "paused"'
for panel in "${panels[@]}"; do
  xdotool key "${panel#*:}"
  picture "${panel%:*}"
  xdotool key b
  picture "${panel%:*}-light"
  xdotool key b "${panel#*:}"
done
xdotool key k
frames 4
xdotool key o
frames 4
xdotool key f
picture laboratory
kill "$viewer"

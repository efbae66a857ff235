#!/usr/bin/env bash
# Ends the real window in ways that nobody plans, while it records and films: its record is kept, a film is whole or not
# there, and nothing else is left.
#   tests/drive_ends.sh TYG glfw|glut
set -euo pipefail

tyg=$1 backend=$2
limit=90 # seconds for everything, on a slow and busy machine
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/driving.sh"

# start_recording [OPTION...]: a new window that runs, and films where ffmpeg is there.
start_recording() {
  rm -f "$record"
  open_window curtain --window "$backend" --record "$record" "$@"
  press space
  until_true "space starts" in_state running
  press z
  until_true "it runs while it films" later_than 0.3
}
# ended WHAT CODE: the window ends with this code; its record can be replayed, and there is no hidden file.
ended() {
  local code=0
  wait "$viewer" || code=$?
  viewer=
  ((code == $2)) || fail "$1: it left with $code"
  "$tyg" run --replay "$record" >/dev/null || fail "$1: the record is not good"
  [[ -z $(find . -name '.tyg-*') ]] || fail "$1: it left $(find . -name '.tyg-*')"
}

for signal in HUP TERM; do
  start_recording
  kill -"$signal" "$viewer"
  ended "SIG$signal" 130
done
if command -v ffmpeg >/dev/null; then
  for movie in tyg-curtain-1.mp4 tyg-curtain-2.mp4; do
    ffmpeg -v error -i "$movie" -f null - 2>&1 | grep . && fail "$movie cannot be played"
  done
fi

# Whoever reads the messages has gone; then the display goes, and Xlib ends the program. The display is one of its own: that
# of xvfb-run must stay until the end. What is on the graphics card, where there is one, has to come back first.
: >"$work/display"  # which is looked at before Xvfb has begun
Xvfb -displayfd 3 -screen 0 "${screen}x24" -nolisten tcp 3>"$work/display" 2>/dev/null &
server=$!
trap 'kill "$server" 2>/dev/null || true; cleanup' EXIT
for ((turn = 0; turn < turns && $(wc -l <"$work/display") == 0; ++turn)); do sleep 0.05; done
DISPLAY=:$(<"$work/display")
start_recording --device gpu
kill -PIPE "$viewer"
few_frames
kill -KILL "$server"
ended "the display" 1
[[ ! -e tyg-curtain-3.mp4 ]] || fail "half a film was kept"
echo "$backend: whatever ends the window, its record is kept"

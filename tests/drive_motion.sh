#!/usr/bin/env bash
# Opens motions of other programs in the real window under Xvfb, as a person would: from the control panel, by a path that
# is typed and by a click on the list of files. Reads from the screen, where ffmpeg is installed, that the verdict on a right
# motion is green and the one on a wrong motion is not, and that a file that does not fit changes nothing. Places are those of a 1280x720 window.
#   tests/drive_motion.sh TYG SOURCE_DIR PYTHON [PICTURES]     with PICTURES, a folder: keeps pictures there
set -euo pipefail

tyg=$1 source_dir=$(readlink -f "$2") python=$3 pictures=${4:+$(readlink -m "$4")} backend=glfw
limit=220 # seconds for everything, on a slow and busy machine
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/driving.sh"

if [[ -n $pictures ]]; then mkdir -p "$pictures"; fi
picture() {
  few_frames 6
  [[ -z $pictures ]] || ffmpeg -v error -y -f x11grab -video_size "$screen" -i "$DISPLAY" -frames:v 1 "$pictures/$1.png"
}
# How many points of the ghost's panel are of a colour, R G B, but for the edges of letters.
points_of() {
  ffmpeg -v error -f x11grab -video_size 390x500 -i "$DISPLAY+876,44" -frames:v 1 -f rawvideo -pix_fmt rgb24 - |
    od -An -v -tu1 -w3 | awk -v r="$1" -v g="$2" -v b="$3" \
      '($1 - r)^2 + ($2 - g)^2 + ($3 - b)^2 < 300 { ++count } END { print count + 0 }'
}
# said_in GOOD|WARNING: polls until the panel has a sentence in that colour, and none in the other one.
said_in() {
  local turn good warning
  command -v ffmpeg >/dev/null || { few_frames 40 && return; }
  for ((turn = 0; turn < turns; ++turn)); do
    few_frames 2
    good=$(points_of 84 200 160) warning=$(points_of 255 186 96)
    if [[ $1 == GOOD ]] && ((good > 200 && warning < 20)); then return; fi
    if [[ $1 == WARNING ]] && ((warning > 200 && good < 20)); then return; fi
  done
  picture failed
  fail "the panel never says anything in the colour of $1: $good good points, $warning of warning"
}

program=$source_dir/examples/marking/four_particles.py
"$python" "$program" >right.csv
sed 's/force\[j\]\[k\] -= f/force[j][k] -= 0 * f/' "$program" >one_end.py
"$python" one_end.py >wrong.csv
printf 't,particle,x,y,z\n1,0,0,0,0\n' >odd.csv

open_window four-particles --integrator leapfrog --dt 2ms
press k
few_frames

# A path that is typed: no letter of it is a key of the window.
click 340 122
xdotool type --delay 100 right.csv
few_frames
picture menu
xdotool key Return
said_in GOOD
read_log && in_state waiting || fail "a letter of the path acted on the cloth"
picture right

# The list, in the order of the alphabet: odd.csv, right.csv, view.csv, wrong.csv.
click 340 122
click 400 233
said_in WARNING
picture wrong

# What does not fit is refused, and the motion before stays.
click 340 122
click 400 170
few_frames 8
said_in WARNING
picture odd
press Escape # closes the menu alone
few_frames
said_in WARNING

# It moves with the time of the run, and the cloth is coloured by how far it is from it.
press space
until_true "the cloth swings" later_than 1
press space
until_true "it pauses" in_state paused
picture running
[[ $alarm == ok && $pushes == 0 ]] || fail "clicks in the menu reached the cloth"

# The verdict on a motion goes with its sheet.
click 240 92
for ((notch = 0; notch < 20; ++notch)); do xdotool mousemove 240 300 click 4; done
few_frames
click 200 120
until_true "another scene waits" in_state waiting
few_frames 4
! command -v ffmpeg >/dev/null || (($(points_of 255 186 96) < 20)) || fail "the verdict stays where the sheet has gone"
picture other
for panel in ghost control; do
  press Escape
  few_frames
done
press Escape
wait_for_end "Escape"
echo "motions of other programs are opened, checked and shown"

#!/usr/bin/env bash
# A person's worst ten seconds, or hours of them by hand: random keys, clicks, drags, wheel, window sizes and scenes in the
# real window under Xvfb. It must go on logging frames with sane numbers all the while, and leave with exit code 0.
#   tests/drive_random.sh TYG [SECONDS [SEED [glfw|glut]]]
set -euo pipefail

tyg=$1 seconds=${2:-10} seed=${3:-1} backend=${4:-glfw}
limit=$((2 * seconds + 180)) turns=1200
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/driving.sh"

# Every key but Esc, as xdotool names it.
keys=(space space comma period semicolon apostrophe j r w a s d q e f bracketleft bracketright v m Return k o c g t equal
  slash y z h l x n p i u b F1 F2 F3 F4 question Left Right Up Down ctrl+c ctrl+z ctrl+y {0..9} minus)
width=${screen%x*} height=${screen#*x}
RANDOM=$seed
some_key() { key=${keys[RANDOM % ${#keys[@]}]}; }
some_place() { place="$((RANDOM % width)) $((RANDOM % height))"; }
random_input() {
  some_place
  local from=$place
  some_place
  some_key
  case $((RANDOM % 12)) in
    [0-3]) xdotool key "$key" ;;
    4) xdotool keydown "${key#ctrl+}" && few_frames 2 && xdotool keyup "${key#ctrl+}" ;;
    [5-6]) xdotool mousemove $place && few_frames 1 && xdotool mousedown 1 && few_frames 1 && xdotool mouseup 1 ;;
    7) xdotool mousemove $from mousedown 1 mousemove $place && few_frames 1 && xdotool mouseup 1 ;;
    8) xdotool mousemove $from mousedown 3 mousemove $place && few_frames 1 && xdotool mouseup 3 ;;
    9) xdotool mousemove $place click $((RANDOM % 2 + 4)) ;;
    10) # one of the scenes in the gallery, or of what lies over it
      xdotool key o && few_frames 2
      xdotool mousemove $((width - RANDOM % 400)) $((RANDOM % height)) && few_frames 1 && xdotool mousedown 1 && few_frames 1
      xdotool mouseup 1 key o
      ;;
    11) # seldom smaller than can be used, most often as large as the screen
      if ((RANDOM % 3 > 0)); then place="$((width - 1)) $((height - 1))"; fi
      xdotool windowsize "$window" $((${place% *} + 1)) $((${place#* } + 1))
      ;;
  esac
}

open_window curtain --window "$backend" --record "$record"
inputs=0 end=$((SECONDS + seconds))
while ((SECONDS < end)); do
  random_input
  few_frames 1
  inputs=$((inputs + 1))
done

read_log && frames=$frame
xdotool windowsize "$window" "$width" "$height" mousemove $((width / 2)) $((height / 2))
for ((turn = 0; turn < 100; ++turn)); do # one panel or open list after the other, and then the window
  kill -0 "$viewer" 2>/dev/null || break
  xdotool key Escape
  sleep 0.2
done
wait_for_end "Escape"
if grep -qE 'nan|inf' <(cut -d, -f1-12 "$log" | tail -n +2); then fail "a number in the log is none"; fi
[[ -s $record ]] || fail "nothing was recorded"
echo "$backend: $inputs random inputs in $seconds s, seed $seed, $frames frames, and the window is well"

#!/usr/bin/env bash
# Drives the real window with real key and mouse events under Xvfb and follows it through its log. Every state is waited
# for by polling; nothing is slept for.
#   tests/drive_viewer.sh TYG glfw|glut
set -euo pipefail

tyg=$1 backend=$2
limit=120 # seconds for everything, on a slow and busy machine

for tool in xvfb-run xauth xdotool; do
  command -v "$tool" >/dev/null || { echo "missing: $tool (.ci/setup installs it)" && exit 1; }
done
if [[ -z ${TYG_DRIVEN:-} ]]; then
  export TYG_DRIVEN=1
  exec timeout --kill-after=5 "$limit" xvfb-run -a -s "-screen 0 1280x720x24 -nolisten tcp" "$0" "$@"
fi

work=$(mktemp -d)
log=$work/view.csv record=$work/record.csv
cleanup() {
  if [[ -n ${viewer:-} ]]; then kill "$viewer" 2>/dev/null || true; fi
  rm -rf "$work"
}
trap cleanup EXIT

fail() {
  echo "$backend: $*; the log ends with:"
  tail -n 3 "$log" || true
  exit 1
}

# The newest whole line of the log, as shell variables named after its columns.
look() {
  local line
  line=$(tail -n 2 "$log" 2>/dev/null | grep ',.*,.*,.*,.*,.*,.*,.*,.*,.*,.*,.*,' | grep -v '^frame' | tail -n 1) || return 1
  IFS=, read -r frame _ sim_s state integrator dt eye_x eye_y eye_z picked pushes kinetic_J alarm <<<"$line"
  [[ -n ${alarm:-} ]]
}
# Arithmetic on those variables: `is "$sim_s > 0"`.
is() { awk "BEGIN { exit !($1) }"; }
# until_true WHAT CONDITION...: polls until the condition, a command, holds for the newest line.
until_true() {
  local what=$1
  shift
  for ((turn = 0; turn < 600; ++turn)); do
    kill -0 "$viewer" 2>/dev/null || fail "the viewer ended while waiting: $what"
    if look && "$@"; then return; fi
    sleep 0.05
  done
  fail "never happened: $what"
}
in_state() { [[ $state == "$1" ]]; }
uses() { [[ $integrator == "$1" ]]; }
later_than() { is "$sim_s > $1"; }
at_time() { is "($sim_s - $1)^2 < 1e-18"; }
pushed() { [[ $pushes == "$1" ]]; }
frames_since() { ((frame >= $1)); }
eye_moved() { is "($eye_x - $old_x)^2 + ($eye_y - $old_y)^2 + ($eye_z - $old_z)^2 > 1e-8"; }
press() { xdotool key --clearmodifiers "$1"; }
few_frames() {
  look
  until_true "three more frames" frames_since "$((frame + 3))"
}

"$tyg" view curtain --window "$backend" --log "$log" --record "$record" &
viewer=$!

until_true "it opens waiting" in_state waiting
is "$sim_s == 0" || fail "it does not open at time zero"
few_frames
is "$sim_s == 0" || fail "it does not wait"
window=$(xdotool search --sync --onlyvisible --name '^Tyg' | head -n 1)

press space
until_true "space starts" in_state running
until_true "time passes" later_than 0.2
is "$kinetic_J > 0" || fail "the cloth does not move"

press space
until_true "space pauses" in_state paused
paused_at=$sim_s
few_frames
is "$sim_s == $paused_at" || fail "time passes while paused"

press period
until_true "a full stop makes one step" at_time "$(awk "BEGIN { printf \"%.17g\", $paused_at + $dt }")"
in_state paused || fail "it does not stay paused after a step"

# The cloth starts in the middle of the window's width; the lower corners show the ground alone.
for key in w a s d q e; do
  look
  old_x=$eye_x old_y=$eye_y old_z=$eye_z
  xdotool keydown $key
  until_true "the eye moves with $key" eye_moved
  xdotool keyup $key
done
few_frames
look && old_x=$eye_x old_y=$eye_y old_z=$eye_z
few_frames
look && ! eye_moved || fail "the eye moves with no key held"
xdotool mousemove --window "$window" 640 300 click 4
until_true "the eye moves with the wheel" eye_moved
press f

press space
until_true "it goes on" later_than "$(awk "BEGIN { print $paused_at + 0.3 }")"
press space
until_true "it pauses" in_state paused
press f
few_frames
# Somewhere on this column of pixels there is cloth; a click beside it would push the middle particle, 210.
clicks=0 hit=
for height in 360 320 400 280 440 240 480 200; do
  xdotool mousemove --window "$window" 600 $height click 1
  clicks=$((clicks + 1))
  until_true "a click pushes" pushed $clicks
  if ((picked != 210 && picked >= 0 && picked < 400)); then hit=$picked && break; fi
done
[[ -n $hit ]] || fail "no click met the cloth"
xdotool mousemove --window "$window" 4 600 click 1
until_true "a click that misses counts" pushed $((clicks + 1))
((picked == 210)) || fail "a click that misses pushed particle $picked, not the middle one"
press space
until_true "it runs with the pushes" in_state running

methods=(explicit-euler symplectic-euler report-rk4 leapfrog rk4)
for number in 2 3 4 5; do
  press $number
  until_true "$number chooses a method" uses "${methods[number - 1]}"
done
in_state running || fail "choosing methods stopped it"
[[ $alarm == ok ]] || fail "the alarm went"

look && old_x=$eye_x old_y=$eye_y old_z=$eye_z
press r
until_true "R restarts" at_time 0
eye_moved && fail "R moves the camera"
in_state waiting || fail "R does not wait"

# The last run is the one that is recorded.
press space
until_true "it runs again" later_than 0.1
xdotool mousemove --window "$window" 4 600 mousedown 1
until_true "the held button pushes" pushed $((clicks + 2))
until_true "and goes on" later_than 0.4
xdotool mouseup 1
press 4
until_true "the method changes" uses leapfrog
until_true "the push dies down" later_than 0.6

# A restart that is never started leaves that record alone.
press r
until_true "R restarts once more" at_time 0
press Escape
code=0
wait "$viewer" || code=$?
viewer=
((code == 0)) || fail "Escape left with $code"
"$tyg" run curtain --replay "$record" >/dev/null || fail "the record does not replay to the same bits"
grep -q 'push' "$record" && grep -q 'leapfrog' "$record" || fail "the record misses the push or the method"
echo "$backend: the window does what its keys say"

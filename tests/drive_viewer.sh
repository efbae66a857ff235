#!/usr/bin/env bash
# Drives the real window with real key and mouse events under Xvfb and follows it through its log. Every state is waited
# for by polling; nothing is slept for.
#   tests/drive_viewer.sh TYG glfw|glut
set -euo pipefail

tyg=$1 backend=$2
limit=200 # seconds for everything, on a slow and busy machine
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/driving.sh"

open_window curtain --window "$backend" --record "$record"
is "$sim_s == 0" || fail "it does not open at time zero"
few_frames
is "$sim_s == 0" || fail "it does not wait"

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
  read_log
  old_x=$eye_x old_y=$eye_y old_z=$eye_z
  xdotool keydown $key
  until_true "the eye moves with $key" eye_moved
  xdotool keyup $key
done
few_frames
read_log && old_x=$eye_x old_y=$eye_y old_z=$eye_z
few_frames
read_log && ! eye_moved || fail "the eye moves with no key held"
xdotool mousemove --window "$window" 640 300 click 4
until_true "the eye moves with the wheel" eye_moved
press f

press space
until_true "it goes on" later_than "$(awk "BEGIN { print $paused_at + 0.3 }")"
press space
until_true "it pauses" in_state paused
press f
few_frames
# Somewhere on this column of pixels there is cloth.
clicks=0
for height in 360 320 400 280 440 240 480 200; do
  xdotool mousemove --window "$window" 640 $height click 1
  few_frames
  read_log
  if ((pushes == 1)); then clicks=1 && break; fi
  [[ $pushes == 0 ]] || fail "a click pushed $pushes times"
done
((clicks == 1 && picked >= 0 && picked < 400)) || fail "no click met the cloth"
xdotool mousemove --window "$window" 4 600 click 1
until_true "a click far from the cloth pushes, as the report's does" pushed $((clicks + 1))
((picked == 210)) || fail "a click far from the cloth pushed particle $picked, not the middle one"
read_log && old_x=$eye_x old_y=$eye_y old_z=$eye_z
xdotool mousemove --window "$window" 100 560 mousedown 1 mousemove 140 570
few_frames
xdotool mousemove --window "$window" 200 580 mouseup 1
until_true "a drag beside the cloth orbits" eye_moved
((pushes == clicks + 1)) || fail "a drag beside the cloth pushes"
read_log && old_x=$eye_x old_y=$eye_y old_z=$eye_z
xdotool keydown Left
until_true "the eye does not move, but it runs" frames_since $((frame + 3))
xdotool keyup Left
press f
until_true "F fits the cloth in view again" eye_moved
press space
until_true "it runs with the pushes" in_state running

methods=(explicit-euler symplectic-euler report-rk4 leapfrog rk4)
for number in 2 3 4 5; do
  press $number
  until_true "$number chooses a method" uses "${methods[number - 1]}"
done
in_state running || fail "choosing methods stopped it"
[[ $alarm == ok ]] || fail "the alarm went"

read_log && old_x=$eye_x old_y=$eye_y old_z=$eye_z
press r
until_true "R restarts" at_time 0
eye_moved && fail "R moves the camera"
in_state waiting || fail "R does not wait"

# The step is dragged past its limit of 4.26 ms: the cloth freezes at its last good frame.
press 5
press space
until_true "it runs with rk4" in_state running
drag_to_failure() {
  read_log
  xdotool keydown bracketright
  until_true "the step passes its limit" step_past 0.0044
  xdotool keyup bracketright
  until_true "the alarm freezes it" in_state frozen
  [[ $alarm != ok ]] || fail "it froze without an alarm"
  broke_at=$sim_s
}
drag_to_failure
press comma
until_true "it steps back out of the failure" in_state paused
until_true "stepping back goes back" earlier_than "$broke_at"
[[ $alarm == ok ]] || fail "the moment before the failure is not well"
press period
until_true "and forward again" at_time "$broke_at"
for ((turn = 0; turn < 200; ++turn)); do # into the failure again, however many steps it takes
  read_log && in_state frozen && break
  press period
done
until_true "it fails again where it failed" in_state frozen
press v
until_true "a safe step is taken" step_below 0.0043
until_true "and it goes on past the failure" later_than "$(awk "BEGIN { print $broke_at + 0.3 }")"
in_state running || fail "it does not run with the safe step"

# Once more, and out by a button: the first one, below the sentence.
drag_to_failure
press space
few_frames
in_state frozen || fail "space goes on into a failure"
xdotool mousemove --window "$window" 160 575 click 1
until_true "the button takes the safe step" step_below 0.0043
until_true "and it runs on" in_state running

# The last step of docs/first-steps.md: another method needs a smaller step, and then moves beside the true motion.
press r
until_true "R starts again" at_time 0
press 3
until_true "3 is the report's method" uses report-rk4
press v
until_true "V takes a step that holds with it" step_below 0.00278
press space
press g
until_true "it runs beside the ghost" later_than 0.5
in_state running || fail "the report's method does not hold: $state"
press 5
until_true "5 takes rk4 again" uses rk4
press g

# The time line.
press space
until_true "it pauses for the time line" in_state paused
few_frames
late=$sim_s
xdotool mousemove --window "$window" 640 634 mousedown 1
until_true "the middle of the time line is an earlier time" earlier_than "$(awk "BEGIN { print 0.8 * $late }")"
xdotool mousemove --window "$window" 1270 634 mouseup 1
until_true "its right end is the last moment" at_time "$late"
in_state paused || fail "the time line does not pause"

# A click on a key of the list does what the key does, and F1 and ? show all keys.
press r
until_true "R restarts" at_time 0
click 40 63
until_true "a click on the first key starts it" later_than 0.3
for key in F1 question; do
  press $key
  few_frames
  press Escape # closes the keys
  few_frames
done
kill -0 "$viewer" || fail "Esc left instead of closing the keys"
press space
until_true "it pauses again" in_state paused

press semicolon
press r
until_true "R restarts after all that" at_time 0
press apostrophe
xdotool keydown bracketleft
until_true "the held key makes the step smaller" step_below 0.0023 # leapfrog holds below 2.6 ms
xdotool keyup bracketleft

# The last run is the one that is recorded. What is gone back over and done anew is recorded as it was done last.
press f
few_frames
xdotool mousemove --window "$window" 640 330 mousedown 1
until_true "the held button pushes, and starts the cloth" pushed $((clicks + 2))
until_true "and goes on" later_than 0.4
xdotool mouseup 1
press space
until_true "it pauses once more" in_state paused
few_frames
now=$sim_s
for ((turn = 0; turn < 10; ++turn)); do press comma; done
until_true "it goes back" earlier_than "$now"
press space
press 4
until_true "the method changes" uses leapfrog
until_true "the push dies down" later_than 0.6

# A restart that is never started leaves that record alone.
press r
until_true "R restarts once more" at_time 0
press Escape
wait_for_end "Escape"
"$tyg" run curtain --replay "$record" >/dev/null || fail "the record does not replay to the same bits"
grep -q 'push' "$record" && grep -q 'leapfrog' "$record" || fail "the record misses the push or the method"

# A cloth that lies still falls asleep: it runs, and no time passes until it is pushed.
cat >"$work/calm.toml" <<END
title = "Calm"
sheet = { columns = 4, rows = 4, spacing = 0.1, start = "hanging", particle_mass = 0.018, pins = ["top"] }
springs = { structural = { ks = 1200, kd = 0.1 }, shear = { ks = 900, kd = 0.1 } }
world = { drag = 0.3 }
run = { duration = 1, integrator = "leapfrog", dt = 0.002 }
END
open_window "$work/calm.toml" --window "$backend"
press space
until_true "it runs" later_than 1
few_frames
until_true "it falls asleep" does_not_move
few_frames
is "$sim_s == $seen" || fail "it does not sleep: $sim_s after $seen"
asleep_at=$sim_s
xdotool mousemove 4 600 click 1
until_true "a push wakes it" later_than "$asleep_at"
press Escape
wait_for_end "Escape"
echo "$backend: the window does what its keys say"

# What the scripts that drive the real window share: a virtual screen, the log's newest line, waiting for what it says.
# To be sourced, with tyg, backend and limit (seconds for everything) set, and where they differ from these the screen and
# how often until_true looks; starts the script again under Xvfb. From then on the current folder, where the window keeps
# files, and the folder of what it remembers are temporary.
screen=${screen:-1280x720} turns=${turns:-600}

for tool in xvfb-run xauth xdotool; do
  command -v "$tool" >/dev/null || { echo "missing: $tool (.ci/setup installs it)" && exit 1; }
done
if [[ -z ${TYG_DRIVEN:-} ]]; then
  export TYG_DRIVEN=1
  exec timeout --kill-after=5 "$limit" xvfb-run -a -s "-screen 0 ${screen}x24 -nolisten tcp" "$0" "$@"
fi

tyg=$(readlink -f "$tyg") work=$(mktemp -d)
cd "$work"
export XDG_STATE_HOME=$work/state XDG_CONFIG_HOME=$work/config
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
read_log() {
  local line
  line=$(tail -n 2 "$log" 2>/dev/null | grep ',.*,.*,.*,.*,.*,.*,.*,.*,.*,.*,.*,.*,.*,.*,.*,' | grep -v '^frame' | tail -n 1) || return 1
  IFS=, read -r frame _ sim_s state integrator dt eye_x eye_y eye_z picked pushes kinetic_J alarm tool held pins cuts <<<"$line"
  [[ -n ${cuts:-} ]]
}
# Arithmetic on those variables: `is "$sim_s > 0"`.
is() { awk "BEGIN { exit !($1) }"; }
# until_true WHAT CONDITION...: polls until the condition, a command, holds for the newest line.
until_true() {
  local what=$1
  shift
  local turn
  for ((turn = 0; turn < turns; ++turn)); do
    kill -0 "$viewer" 2>/dev/null || fail "the viewer ended while waiting: $what"
    if read_log && "$@"; then return; fi
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
step_past() { is "$dt > $1"; }
step_below() { is "$dt < $1"; }
earlier_than() { is "$sim_s < $1"; }
# Running, and no time passed over eight lines of the log.
does_not_move() {
  if [[ $state != running || $sim_s != "${seen:-}" ]]; then seen=$sim_s seen_at=$frame; fi
  ((frame >= seen_at + 8))
}
press() { xdotool key --clearmodifiers "$1"; }
# few_frames [COUNT]: from now on.
few_frames() {
  read_log
  until_true "more frames" frames_since "$((frame + ${1:-3}))"
}
# ImGui sees the mouse once a frame: it must have come to a place before a button is pressed there.
point() { xdotool mousemove "$@" && few_frames; }
click() {
  point "$@"
  xdotool mousedown 1
  few_frames
  xdotool mouseup 1
  few_frames
}
# open_window ARGUMENTS...: a window that waits, which `window` names then; as large as the screen, or `size`.
open_window() {
  : >"$log"
  "$tyg" view "$@" --size "${size:-$screen}" --log "$log" &
  viewer=$!
  until_true "it opens waiting" in_state waiting
  window=$(xdotool search --sync --onlyvisible --name '^Tyg' | head -n 1)
}
# wait_for_end WHAT: the viewer leaves by itself, with exit code 0.
wait_for_end() {
  local turn
  for ((turn = 0; turn < turns; ++turn)); do
    if ! kill -0 "$viewer" 2>/dev/null; then
      local code=0
      wait "$viewer" || code=$?
      viewer=
      ((code == 0)) || fail "$1 left with $code"
      return
    fi
    sleep 0.05
  done
  fail "$1 does not leave"
}

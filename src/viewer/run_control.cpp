// Going on, going back and failing. Wherever time comes to rest at another tick, the listener is told that other
// settings may be in use there.
#include "viewer/run_control.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <utility>

#include "study/limits/fast_contact.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

/// The simulation may take this long a frame, or as long as everything else takes where that is longer, s.
constexpr double kSimulatingSeconds = 0.012;
/// A cure goes on from this long before the last good frame, where the failure has not yet grown; simulated s.
constexpr double kBackSeconds = 0.25;
/// A replay shows this much again, simulated s.
constexpr double kReplaySeconds = 1;

}  // namespace

std::string_view nameOf(RunState state) {
  constexpr std::array<std::string_view, 4> kNames{"waiting", "running", "paused", "frozen"};
  return kNames.at(static_cast<std::size_t>(state));
}

RunControl::RunControl(Simulation simulation, Clock clock, Notes& notes, RunListener& listener)
    : clock_(std::move(clock)),
      notes_(notes),
      listener_(listener),
      simulation_(std::move(simulation)),
      playback_(simulation_.dt()),
      ticks_(clock_),
      failure_(clock_) {
  ticks_.guard(simulation_);
  history_.begin(simulation_);
}

void RunControl::startOrPause() {
  if (state_ == RunState::Frozen) {
    return notes_.say(failure_.cure()
                          ? "space would go on into the failure: take one of the ways out, or Enter to see it."
                          : "From here nothing goes on: R restarts.");
  }
  if (state_ != RunState::Running) return goOn();
  playback_.endReplay();
  state_ = RunState::Paused;
}

void RunControl::goOn() {
  intervene();
  failure_.setRunsOn(failure_.runsOn() && simulation_.status() != Status::Ok);
  simulation_.keepGoing(failure_.runsOn());
  failure_.thaw();
  if (failure_.runsOn()) playback_.slowDown(BreakRecord::kTicksPerSecond * simulation_.dt());
  state_ = RunState::Running;
  playback_.clock().restart();
}

void RunControl::step() {
  if (state_ == RunState::Frozen || seeking()) return;
  playback_.endReplay();
  state_ = RunState::Paused;
  run(1, 0);
  if (state_ == RunState::Paused) listener_.settingsReturned();
}

Simulation& RunControl::intervene() {
  playback_.endReplay();
  sleep_.wake();
  journey_.giveUp();
  if (history_.past()) history_.cut(simulation_);
  return simulation_;
}

/// Pauses there, which may take some frames, and then does `then`.
void RunControl::turnTo(std::int64_t tick, std::function<void()> then) {
  if (state_ == RunState::Waiting) return;
  playback_.endReplay();
  sleep_.wake();
  if (failure_.lastGood() && !failure_.runsOn()) tick = std::min(tick, failure_.lastGood()->tick);
  state_ = RunState::Paused;
  failure_.thaw();
  notes_.clear();
  simulation_.keepGoing(true);
  history_.turnTo(simulation_, tick);
  journey_.begin(std::move(then));
  seek();
}

void RunControl::turnToTime(double time) { turnTo(history_.tickAt(time, simulation_)); }

void RunControl::seek() {
  run(history_.target() - simulation_.ticks(), kSimulatingSeconds);
  if (!seeking() || simulation_.ticks() < history_.target()) return;
  const auto then = journey_.arrive();
  simulation_.keepGoing(failure_.runsOn());
  listener_.settingsReturned();
  show();
  if (then) then();
}

void RunControl::replay() {
  turnTo(history_.tickAt(shown_.time() - kReplaySeconds, simulation_), [this] {
    playback_.beginReplay();
    state_ = RunState::Running;
    playback_.clock().restart();
  });
}

bool RunControl::canRunOn() const {
  return failure_.cure() && !failure_.runsOn() && simulation_.status() == Status::Unstable &&
         !BreakRecord::hasBroken(shown_);
}

void RunControl::runOn() {
  if (!canRunOn()) return;
  breaking_.clear();
  breaking_.note(shown_);
  playback_.slowDown(BreakRecord::kTicksPerSecond * simulation_.dt());
  failure_.thaw();
  failure_.setRunsOn(true);
  simulation_.keepGoing(true);
  state_ = RunState::Running;
  playback_.clock().restart();
}

bool RunControl::turnBeforeFailure(std::function<void()> then) {
  if (!failure_.lastGood() || (!failure_.cure() && !failure_.runsOn())) return false;
  failure_.setRunsOn(false);
  turnTo(history_.tickAt(failure_.lastGood()->time - kBackSeconds, simulation_), std::move(then));
  return true;
}

void RunControl::startOver(Simulation fresh) {
  std::string trouble;
  try {
    if (onRunEnd_ && history_.newest(simulation_).ticks > 0) onRunEnd_(record());
  } catch (const std::exception& error) {
    trouble = error.what();
  }
  playback_.endReplay();
  sleep_.wake();
  journey_.giveUp();
  failure_.restart();
  breaking_.clear();
  simulation_ = std::move(fresh);
  ticks_.guard(simulation_);
  history_.begin(simulation_);
  state_ = RunState::Waiting;
  isFastContactNoted_ = false;
  notes_.warn(trouble);
  showStart();
}

void RunControl::startOver(Simulation fresh, EventLog log) {
  for (const Event& event : log.events) {
    if (const auto* change = std::get_if<MethodEvent>(&event.action)) (void)findMethod(change->method);
  }
  startOver(std::move(fresh));
  history_.recall(simulation_, std::move(log));
  if (!history_.past()) return;
  playback_.beginReplay(1);
  state_ = RunState::Running;
  playback_.clock().restart();
}

void RunControl::showStart() {
  show();
  listener_.runBegan();
}

void RunControl::advance(double frameSeconds, double otherSeconds) {
  if (seeking()) return seek();
  if (state_ != RunState::Frozen && simulation_.ticks() == shown_.tick()) shown_.followSheet(simulation_);
  if (state_ != RunState::Running || asleep()) return;
  playback_.clock().setTick(simulation_.dt());
  playback_.clock().ran(run(playback_.clock().due(frameSeconds), std::max(kSimulatingSeconds, otherSeconds)));
  if (!playback_.replaying()) return;
  listener_.settingsReturned();
  if (history_.past() || state_ != RunState::Running) return;
  playback_.endReplay();
  state_ = RunState::Paused;
}

/// Runs up to `ticks`, one at least where any are due, and stops when `seconds` are over. Returns how many it ran.
int RunControl::run(std::int64_t ticks, double seconds) {
  const std::int64_t first = simulation_.ticks();
  try {
    ticks_.run(simulation_, history_, listener_, ticks, seconds);
    if (ticks_.takeStall()) {
      freezeOnStall();
    } else if (simulation_.ticks() > first && !seeking()) {
      show();
    }
  } catch (const std::exception& error) {
    journey_.giveUp();
    freeze(error.what());
  }
  return static_cast<int>(simulation_.ticks() - first);
}

/// Takes the simulation's state over for drawing, unless the alarm says that it is not worth showing.
void RunControl::show() {
  if (!shown_.take(simulation_, failure_.runsOn())) {
    const double alarm = alarmTimeAhead();
    if (!std::isnan(alarm) || !shown_.take(simulation_, true)) return freezeOnAlarm(alarm);
  }
  if (failure_.runsOn() && simulation_.status() != Status::Ok) {
    breaking_.note(shown_);
    const bool isOver = BreakRecord::hasBroken(shown_) || breaking_.isSeen(simulation_.dt());
    if (isOver && state_ == RunState::Running && !history_.past()) return freezeOnAlarm(failure_.alarmTime());
  } else if (!failure_.lastGood()) {
    breaking_.clear();
  }
  if (simulation_.status() == Status::Ok && !history_.past()) failure_.passed(shown_.tick());
  noteFastContact();
  if (state_ == RunState::Running && !playback_.replaying() && !listener_.actsAt(shown_.tick())) {
    sleep_.follow(simulation_, shown_.kinetic());
  } else {
    sleep_.wake();
  }
}

/// A look between two energy checks has found the run unstable. When the next check will find it so too: a failure has
/// this time whatever frames there were. The simulation stays here, and NaN says that it passes that check.
double RunControl::alarmTimeAhead() {
  if (failure_.lastGood() && (history_.past() || failure_.runsOn())) return failure_.alarmTime();
  constexpr int kTicks = 64;  // a check comes every 64 steps, and a tick is a step at least
  const Snapshot here = simulation_.save();
  simulation_.tick(kTicks);
  const bool stalls = ticks_.takeStall() && simulation_.status() == Status::Ok;
  const double time = stalls ? here.time() : simulation_.alarmTime();
  simulation_.restore(here);
  return time;
}

/// Said once in a run.
void RunControl::noteFastContact() {
  if (isFastContactNoted_ || state_ != RunState::Running || simulation_.status() != Status::Ok) return;
  std::string note = fastContactNote(simulation_);
  if (note.empty()) return;
  isFastContactNoted_ = true;
  notes_.warn(std::move(note));
}

void RunControl::freezeOnAlarm(double alarmTime) {
  simulation_.check();
  playback_.endReplay();
  listener_.settingsReturned();
  state_ = RunState::Frozen;
  failure_.freezeOnAlarm(simulation_, shown_, alarmTime);
  failure_.setRunsOn(false);
}

/// The simulation is at the beginning of the tick that was given up.
void RunControl::freezeOnStall() {
  if (seeking()) {
    journey_.giveUp();
  } else {
    show();
  }
  if (state_ == RunState::Frozen) return;
  playback_.endReplay();
  listener_.settingsReturned();
  state_ = RunState::Frozen;
  failure_.freezeOnStall(simulation_, shown_, TickRunner::kLongestTick);
}

void RunControl::freeze(std::string message) {
  state_ = RunState::Frozen;
  failure_.freeze(std::move(message));
}

void RunControl::updateMargin(const Scene& chosen) {
  if (state_ == RunState::Frozen) {
    failure_.previewMargin(chosen);
  } else {
    failure_.updateMargin(simulation_);
  }
}

double RunControl::measureLimit() {
  failure_.updateMargin(simulation_);
  return margin().limit;
}

Timeline RunControl::timeline() const {
  return {.first = history_.first().time,
          .shown = shown_.time(),
          .newest = history_.newest(simulation_).time,
          .past = history_.past()};
}

}  // namespace tyg

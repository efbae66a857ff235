// Going on, going back and failing. Wherever time comes to rest at another tick, the listener is told that other
// settings may be in use there.
#include "viewer/run_control.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <utility>

#include "core/simulation/energy_watch.h"
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
  failure_.setRunsOn(failure_.runsOn() && failure_.isPast(shown_.tick()));
  simulation_.keepGoing(failure_.runsOn());
  failure_.thaw();
  if (failure_.runsOn()) playback_.slowDown(ticksPerSecond_ * simulation_.dt());
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
  if (failure_.isPast(tick)) {
    failure_.setRunsOn(!breaking_.moments().empty());
    if (!failure_.runsOn()) tick = failure_.lastGood()->tick;
  }
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
  const bool isThere = simulation_.status() == Status::Unstable || !breaking_.moments().empty();
  return failure_.cure() && failure_.lastGood() && !failure_.runsOn() && isThere;
}

/// From a few ticks before the failure, so that its beginning is seen.
void RunControl::runOn() {
  if (!canRunOn()) return;
  constexpr std::int64_t kBefore = 8;  // ticks
  if (breaking_.moments().empty()) ticksPerSecond_ = BreakRecord::ticksPerSecond(ticksToBreak() + kBefore);
  turnTo(failure_.lastGood()->tick - kBefore, [this] {
    intervene();
    breaking_.clear();
    playback_.slowDown(ticksPerSecond_ * simulation_.dt());
    failure_.setRunsOn(true);
    simulation_.keepGoing(true);
    state_ = RunState::Running;
    playback_.clock().restart();
  });
}

/// How many ticks it takes until there is nothing more to see, where that can be found out at once.
std::int64_t RunControl::ticksToBreak() {
  constexpr double kMostWork = 2e6;  // particles times ticks
  const auto most = std::int64_t(BreakRecord::kMostSeconds * BreakRecord::kMostTicksPerSecond);
  if (double(simulation_.sheet().count()) * double(most) > kMostWork) return most;
  const Snapshot here = simulation_.save();
  ShownState probe = shown_;
  simulation_.keepGoing(true);
  std::int64_t count = 0;
  for (; count < most && !BreakRecord::hasBroken(probe); ++count) {
    ticks_.begin();
    simulation_.tick();
    if (!probe.take(simulation_, true)) break;
  }
  simulation_.keepGoing(false);
  simulation_.restore(here);
  return count;
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
  return static_cast<int>(std::max<std::int64_t>(0, simulation_.ticks() - first));
}

/// Takes the simulation's state over for drawing, unless the alarm says that it is not worth showing.
void RunControl::show() {
  if (!(failure_.runsOn() ? shown_.take(simulation_, true) : shown_.follow(simulation_))) {
    if (failure_.runsOn()) return freezeOnAlarm();
    if (failsAhead()) return goBackToAlarm(), freezeOnAlarm();
    if (!shown_.take(simulation_, true)) return freezeOnAlarm();
  }
  if (failure_.runsOn() && failure_.isPast(shown_.tick())) {
    breaking_.note(shown_);
    const bool isOver = BreakRecord::hasBroken(shown_) || breaking_.isSeen(simulation_.dt());
    if (isOver && state_ == RunState::Running && !history_.past()) return freezeOnAlarm();
  } else if (!failure_.lastGood()) {
    breaking_.clear();
  }
  if (!failure_.runsOn() && simulation_.status() == Status::Ok && !history_.past()) failure_.passed(shown_.tick());
  noteFastContact();
  if (state_ == RunState::Running && !playback_.replaying() && !listener_.actsAt(shown_.tick())) {
    if (isCheckedAnew()) sleep_.follow(simulation_, shown_.kinetic());
  } else {
    sleep_.wake();
  }
}

/// On a device energies are known from checks alone, and speeds would have to be read from there in every frame.
bool RunControl::isCheckedAnew() {
  const std::int64_t checks = simulation_.steps() / kStepsBetweenChecks;
  return std::exchange(checks_, checks) != checks || !shown_.onDevice();
}

/// Whether the next energy check finds the run unstable, as a look between two of them does. The simulation stays here.
bool RunControl::failsAhead() {
  if (simulation_.status() != Status::Ok) return true;
  const Snapshot here = simulation_.save();
  ticks_.begin();
  simulation_.tick(kStepsBetweenChecks);  // a tick is a step at least
  const bool fails = simulation_.status() != Status::Ok || ticks_.takeStall();
  simulation_.restore(here);
  return fails;
}

/// Goes back to the first tick since the last energy check at which the run is found unstable, and takes over what was
/// to be seen before: so a failure has the same time and the same limit whatever frames there were. Where that would
/// keep the window waiting, the present tick is the one.
void RunControl::goBackToAlarm() {
  constexpr int kMostParticles = 20000;
  const std::int64_t here = simulation_.ticks(), steps = simulation_.steps();
  if (simulation_.sheet().count() > kMostParticles || here <= history_.first().ticks) return;
  simulation_.keepGoing(true);
  history_.turnTo(simulation_, here - 1 - (steps + kStepsBetweenChecks - 1) % kStepsBetweenChecks);
  ticks_.begin();
  history_.tick(simulation_, history_.target() - simulation_.ticks());
  while (shown_.take(simulation_, false) && simulation_.ticks() < here) {
    failure_.measureMargin(simulation_);
    ticks_.begin();
    history_.tick(simulation_, 1);
  }
  history_.cut(simulation_);
  simulation_.keepGoing(false);
}

/// Said once in a run.
void RunControl::noteFastContact() {
  if (isFastContactNoted_ || state_ != RunState::Running || simulation_.status() != Status::Ok) return;
  std::string note = fastContactNote(simulation_);
  if (note.empty()) return;
  isFastContactNoted_ = true;
  notes_.warn(std::move(note));
}

void RunControl::freezeOnAlarm() {
  simulation_.check();
  playback_.endReplay();
  listener_.settingsReturned();
  state_ = RunState::Frozen;
  failure_.freezeOnAlarm(simulation_, shown_);
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

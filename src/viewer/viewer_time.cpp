// The viewer's way through time: running, pausing, stepping back, the alarm and the ways out of it.
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/simulation/live_parameters.h"
#include "tyg/methods.h"
#include "viewer/viewer.h"

namespace tyg {
namespace {

/// The simulation may take this long a frame, or as long as everything else takes where that is longer.
constexpr double kSimulatingSeconds = 0.012;
/// Ticks in one call: so many steps are fused.
constexpr std::int64_t kMostTogether = 64;
constexpr double kLongestTick = 2;      // s: then a method of free steps has failed
constexpr double kTickSmoothing = 0.2;  // of the wall time of a tick, from call to call

/// A cure goes on from this long before the last good frame, where the failure has not yet grown; simulated s.
constexpr double kBackSeconds = 0.25;
/// A replay shows this much again, simulated s, at this speed.
constexpr double kReplaySeconds = 1, kReplaySpeed = 0.125;
constexpr double kSlowest = 1.0 / 64;
/// Steps beyond these are of no use in any scene, s.
constexpr double kShortestStep = 1e-7, kLongestStep = 1;

}  // namespace

void Viewer::startOrPause() {
  if (state_ == RunState::Frozen) return;
  if (state_ != RunState::Running) return goOn();
  endReplay();
  state_ = RunState::Paused;
}

/// From the present moment; what came after it is forgotten.
void Viewer::goOn() {
  beforeDeed();
  breaking_ = breaking_ && simulation_.status() != Status::Ok;
  simulation_.keepGoing(breaking_);
  message_.clear();
  cure_.reset();
  state_ = RunState::Running;
  frameClock_.restart();
}

void Viewer::step() {
  if (state_ == RunState::Frozen || seeking_) return;
  endReplay();
  state_ = RunState::Paused;
  run(1, 0);
  if (state_ == RunState::Paused) followSimulation();
}

/// A person's deed at a past moment: from here on everything is new.
void Viewer::beforeDeed() {
  endReplay();
  stillSince_.reset();
  seeking_ = false;
  arrived_ = {};
  if (history_.past()) history_.cut(simulation_);
}

/// Pauses there, which may take some frames, and then does `then`.
void Viewer::turnTo(std::int64_t tick, std::function<void()> then) {
  if (state_ == RunState::Waiting) return;
  endReplay();
  stillSince_.reset();
  if (lastGood_ && !breaking_) tick = std::min(tick, lastGood_->ticks);
  state_ = RunState::Paused;
  message_.clear();
  note_.clear();
  cure_.reset();
  simulation_.keepGoing(true);
  history_.turnTo(simulation_, tick);
  seeking_ = true;
  arrived_ = std::move(then);
  seek();
}

void Viewer::turnToTime(double time) { turnTo(history_.tickAt(time, simulation_)); }

void Viewer::seek() {
  run(history_.target() - simulation_.ticks(), kSimulatingSeconds);
  if (!seeking_ || simulation_.ticks() < history_.target()) return;
  seeking_ = false;
  simulation_.keepGoing(breaking_);
  followSimulation();
  showState();
  if (const auto then = std::exchange(arrived_, {})) then();
}

void Viewer::again() {
  const double from = time_ - kReplaySeconds;
  turnTo(history_.tickAt(from, simulation_), [this] {
    replaying_ = true;
    speedBefore_ = frameClock_.speed();
    frameClock_.setSpeed(std::min(speedBefore_, kReplaySpeed));
    state_ = RunState::Running;
    frameClock_.restart();
  });
}

void Viewer::endReplay() {
  if (replaying_) frameClock_.setSpeed(speedBefore_);
  replaying_ = false;
}

void Viewer::changeSpeed(double factor) {
  frameClock_.setSpeed(std::clamp(frameClock_.speed() * factor, kSlowest, 1.0));
  speedBefore_ = frameClock_.speed();  // a person's choice outlasts the replay in which it is made
}

void Viewer::runOn() {
  if (!cure_ || breaking_ || simulation_.status() != Status::Unstable) return;
  cure_.reset();
  message_.clear();
  breaking_ = true;
  simulation_.keepGoing(true);
  state_ = RunState::Running;
  frameClock_.restart();
}

/// At once, or, after an alarm, shortly before the failure, and goes on from there. What was set since that moment, or
/// while it was frozen, is part of what is wanted: the way back must not lose it.
void Viewer::cureWith(const Scene& wanted) {
  if (seeking_) return;
  if (!lastGood_ || (!cure_ && !breaking_)) return useLive(wanted);
  breaking_ = false;
  turnTo(history_.tickAt(lastGood_->time - kBackSeconds, simulation_), [this, wanted] {
    try {
      beforeDeed();
      useLive(wanted);
      goOn();
    } catch (const std::exception& error) {  // a method that was chosen while it was frozen may refuse the scene
      warn(error.what());
    }
  });
}

void Viewer::takeSafeStep() {
  if (state_ == RunState::Frozen && !cure_) return;
  Scene wanted = scene_;
  const double safe = safeStep(limitInUse());
  const double step = cure_ ? cure_->step : margin().adaptive ? 0 : safe;
  if (step > 0) wanted.dt = step, cureWith(wanted);
}

void Viewer::takeHoldingMethod() {
  if (!cure_ || cure_->method == nullptr) return;
  Scene wanted = scene_;
  wanted.integrator = cure_->method->name;
  cureWith(wanted);
}

/// Another setting was chosen while it was frozen, and a cure keeps it: its step is that one where it holds.
void Viewer::fitCure() {
  if (!cure_) return;
  stepMargin_.lookAhead(scene_);
  if (margin().band() == MarginBand::Past) {
    cure_->step = safeStep(margin().limit);
  } else if (method_ == &simulation_.method() && scene_.dt == simulation_.dt()) {
    cure_->step = findCure(simulation_, margin().limit).step;
  } else {
    cure_->step = scene_.dt;
  }
}

/// s, of the method, step and world that are in use at this moment, not at the last frame.
double Viewer::limitInUse() {
  stepMargin_.look(simulation_, clock_);
  return margin().limit;
}

void Viewer::useStep(double dt) {
  if (state_ == RunState::Frozen || seeking_) return;
  dt = std::clamp(dt, kShortestStep, kLongestStep);
  beforeDeed();
  simulation_.useStep(dt);
  followSimulation();
}

void Viewer::useMethod(const Method& method) {
  if (seeking_) return;
  if (state_ != RunState::Frozen && &method != method_) {
    beforeDeed();
    simulation_.useMethod(method);
  }
  method_ = &method;
  scene_.integrator = method.name;
  fitCure();
}

/// Another moment may have had another method, step or world.
void Viewer::followSimulation() {
  method_ = &simulation_.method();
  scene_.integrator = method_->name;
  scene_.dt = simulation_.dt();
  copyLiveParameters(simulation_.scene(), scene_);
  frameClock_.setTick(simulation_.dt());
}

void Viewer::restart() { startOver(Simulation(scene_, *method_, settings_)); }

/// Waits at the start of `fresh`, which is a simulation of scene_.
void Viewer::startOver(Simulation fresh) {
  std::string trouble;
  try {
    if (onRunEnd_ && history_.newest(simulation_).ticks > 0) onRunEnd_(record());
  } catch (const std::exception& error) {
    trouble = error.what();
  }
  endReplay();
  stillSince_.reset();
  seeking_ = breaking_ = false;
  arrived_ = {};
  cure_.reset();
  lastGood_.reset();
  simulation_ = std::move(fresh);
  limitTicks();
  positions_.resize(static_cast<std::size_t>(3 * simulation_.sheet().count()));
  history_.begin(simulation_);
  stepMargin_.restart();
  frameClock_.setTick(scene_.dt);
  state_ = RunState::Waiting;
  message_.clear();
  warn(trouble);
  held_.at(static_cast<std::size_t>(InputAction::Poke)) = false;
  pushEnd_ = 0;
  pushedAt_ = -1e9;
  showState();
}

void Viewer::moveCloth(double frameSeconds) {
  if (seeking_) return seek();
  if (state_ != RunState::Running || asleep()) return;
  const double others = frameSeconds_ - simulatingSeconds_;
  frameClock_.ran(run(frameClock_.due(frameSeconds), std::max(kSimulatingSeconds, others)));
  if (replaying_) followSimulation();
  if (replaying_ && !history_.past() && state_ == RunState::Running) {
    endReplay();
    state_ = RunState::Paused;
  }
}

/// Ticks to simulate in one call, so that it takes no longer than `seconds` of wall time.
std::int64_t Viewer::together(std::int64_t most, double seconds) const {
  most = std::min(most, kMostTogether);
  if (held(InputAction::Poke) && pushEnd_ > simulation_.ticks()) most = std::min(most, pushEnd_ - simulation_.ticks());
  if (tickSeconds_ <= 0) return 1;
  return std::clamp(std::int64_t(std::min(seconds / tickSeconds_, 1e9)), std::int64_t{1}, most);
}

/// Runs up to `ticks`, one at least where any are due, and stops when `seconds` are over. Returns how many it ran.
int Viewer::run(std::int64_t ticks, double seconds) {
  const double start = clock_();
  const std::int64_t first = simulation_.ticks(), end = first + ticks;
  double now = start;
  try {
    while (simulation_.ticks() < end && (simulation_.ticks() == first || now - start < seconds)) {
      if (!history_.past()) keepPushing();
      const std::int64_t before = simulation_.ticks();
      tickBegan_ = now;
      history_.tick(simulation_, together(end - before, start + seconds - now));
      const std::int64_t ran = simulation_.ticks() - before;
      if (ran == 0 || late_) break;  // the alarm went, or a tick was given up
      const double took = (clock_() - now) / double(ran);
      tickSeconds_ += (tickSeconds_ > 0 ? kTickSmoothing : 1) * (took - tickSeconds_);
      now = clock_();
    }
    if (late_) {
      freezeOnStall();
    } else if (simulation_.ticks() > first && !seeking_) {
      showState();
    }
  } catch (const std::exception& error) {
    seeking_ = false;
    freeze(error.what());
  }
  return static_cast<int>(simulation_.ticks() - first);
}

/// Takes the simulation's state over for drawing, unless the alarm says that it is not worth showing.
void Viewer::showState() {
  const double kinetic = simulation_.ledger().kinetic;
  const Status status = simulation_.status();
  if (status == Status::NotFinite || (status != Status::Ok && !breaking_)) return freezeOnAlarm();
  next_.resize(positions_.size());
  simulation_.copyPositions(next_);
  // A run past its alarm leaves what a picture can hold before it leaves what can be computed with.
  if (!std::ranges::all_of(next_, [](float x) { return std::isfinite(x); })) return freezeOnAlarm();
  positions_.swap(next_);
  kinetic_ = kinetic;
  time_ = simulation_.time();
  shownTick_ = simulation_.ticks();
  if (status == Status::Ok && lastGood_ && !history_.past() && shownTick_ > lastGood_->ticks) lastGood_.reset();
  box_ = boxAround(positions_);
  watchForSleep();
}

void Viewer::watchForSleep() {
  if (state_ != RunState::Running || replaying_ || !still()) return stillSince_.reset();
  if (!stillSince_ || *stillSince_ > time_) stillSince_ = time_;
}

bool Viewer::still() const {
  const Sheet& sheet = simulation_.sheet();
  const double slow = kStillSpeed * kStillSpeed;
  // Of so much kinetic energy no look at single particles is needed: it would take all of them.
  if (simulation_.ticks() < pushEnd_ || !(kinetic_ < sheet.count() * sheet.particleMass * slow / 2)) return false;
  const auto toCome = [this](const Push& push) { return push.at + push.duration > time_; };
  if (std::ranges::any_of(simulation_.scene().pushes, toCome)) return false;
  for (int particle = 0; particle < sheet.count(); ++particle) {
    const Vec3 v = simulation_.velocity(particle);
    if (!(v.x * v.x + v.y * v.y + v.z * v.z < slow)) return false;
  }
  return true;
}

void Viewer::freezeOnAlarm() {
  endReplay();
  followSimulation();
  const double limit = limitInUse();
  const Cure cure = findCure(simulation_, limit);
  freeze(describeFailure(simulation_, limit, cure));
  cure_ = cure;
  if (!lastGood_) lastGood_ = History::Moment{shownTick_, time_};
}

/// The simulation stands at the beginning of the tick that was given up.
void Viewer::freezeOnStall() {
  late_ = false;
  if (!std::exchange(seeking_, false)) showState();
  if (state_ == RunState::Frozen) return;
  endReplay();
  followSimulation();
  const Cure cure = findCure(simulation_, limitInUse());
  freeze(describeStall(simulation_, kLongestTick, cure));
  cure_ = cure;
  if (!lastGood_) lastGood_ = History::Moment{shownTick_, time_};
}

/// A method of free steps may choose ever smaller ones: no frame waits for that.
void Viewer::limitTicks() {
  simulation_.observe([this] {
    late_ = clock_() - tickBegan_ >= kLongestTick;
    return !late_;
  });
}

void Viewer::freeze(std::string message) {
  state_ = RunState::Frozen;
  cure_.reset();
  message_ = std::move(message);
}

Timeline Viewer::timeline() const {
  return {.first = history_.first().time,
          .shown = time_,
          .newest = history_.newest(simulation_).time,
          .past = history_.past()};
}

}  // namespace tyg

// How a simulation goes from one stop time to the next, and from tick to tick, with its pushes beginning and ending.
#include <algorithm>
#include <optional>

#include "core/simulation/simulation_body.h"

namespace tyg {
namespace {

constexpr double kSameTime = 1e-9;   // of dt: stop times closer than this are one
constexpr double kMostSteps = 1e15;  // of one run: more would not end, and could not be counted

}  // namespace

/// A step longer than the run does not make the whole run one moment.
Pushes::Instant Simulation::Body::now() const {
  return {run.time, kSameTime * std::min(run.dt, scene.duration), run.ticks};
}

void Simulation::Body::switchPushes() {
  if (!run.pushes.switchAt(now(), *moving)) return;
  applyPushes();
  moving->reset();
}

void Simulation::Body::applyPushes() {
  run.pushes.applyTo(*moving);
  forcing = run.pushes.forcing(scene, sheet);
}

/// `steps` steps of h from now on, the last of which ends at `end`.
void Simulation::Body::walk(std::int64_t steps, double h, double end) {
  const double from = run.time;
  for (std::int64_t done = 0; done < steps && !standing();) {
    const auto some = std::min(steps - done, stepsToLook());
    moving->steps(h, int(some));
    done += some;
    count(h, int(some), done == steps ? end : from + double(done) * h);
  }
}

/// Equal steps of at most dt to the next stop, or steps of the method's own choice. Where these become so short that
/// the run would not end, its tolerance is below what rounding leaves of the numbers: it stands still from there.
void Simulation::Body::advanceSegment(double stop) {
  switchPushes();
  if (stepsFreely()) {
    while (!standing() && run.time < stop) {
      const double most = stop - run.time, taken = moving->stepWithin(most, scene.tolerance);
      count(taken, 1, taken == most ? stop : run.time + taken);
      if (most > kMostSteps * taken) {
        if (run.status == Status::Ok) run.alarmTime = run.time;
        run.status = Status::NotFinite;
        run.stuck = true;
      }
    }
    return;
  }
  const double span = stop - run.time;
  const double steps = std::max(1.0, std::ceil(span / run.dt - kSameTime));
  if (steps > kMostSteps) {
    throw InputError("dt: found " + std::to_string(steps) + " steps to the next stop, allowed: up to 1e15");
  }
  walk(std::int64_t(steps), span / steps, stop);
}

void Simulation::Body::advance(double end) {
  while (!standing() && run.time < end - now().sameTime) advanceSegment(run.pushes.nextEdge(now(), end));
}

/// s, when the tick ends that is `ahead` after this one.
double Simulation::Body::tickEnd(std::int64_t ahead) const {
  return run.tickBaseTime + double(run.ticks + 1 + ahead - run.tickBase) * run.dt;
}

/// One, whatever begins or ends in it. Of steps of the method's own choice there may be millions in a tick: it is done
/// whole or, stopped, not at all. The few of dt that a push's edge leaves in a tick are all done.
void Simulation::Body::tick() {
  std::optional<Saved> before;
  if (observer && stepsFreely()) before = save();
  playScript();
  const double end = tickEnd(0);
  if (run.pushes.nextEdge(now(), end) == end && !stepsFreely()) {
    switchPushes();
    walk(1, run.dt, end);
  } else {
    finishing = !stepsFreely();
    advance(end);
    finishing = false;
  }
  if (before && stopAsked && run.time < end - now().sameTime) return restore(*before);
  run.log.ticks = ++run.ticks;
}

/// How many of the next ticks, up to `most`, are one step each with nothing beginning or ending after the first.
std::int64_t Simulation::Body::plainTicks(std::int64_t most) const {
  if (stepsFreely()) return 0;
  most = std::min(most, stepsToLook());
  if (run.scriptNext < run.script.size()) most = std::min(most, run.script[run.scriptNext].tick - run.ticks);
  most = run.pushes.ticksToEdge(run.ticks, most);
  // Half a tick away from the edge of a scene's push there is no doubt about the tick that it lies in.
  const double edge = run.pushes.nextEdge(now(), tickEnd(most)) - run.dt / 2;
  while (most > 0 && tickEnd(most - 1) > edge) --most;
  return most;
}

/// The same as that many single ticks, to the last bit, with the method's steps in one call where nothing comes between
/// them.
void Simulation::Body::ticks(std::int64_t count) {
  const std::int64_t end = run.ticks + count;
  while (run.ticks < end && !standing()) {
    playScript();
    const std::int64_t plain = plainTicks(end - run.ticks);
    if (plain < 2) {
      tick();
      continue;
    }
    switchPushes();
    moving->steps(run.dt, int(plain));
    this->count(run.dt, int(plain), tickEnd(plain - 1));
    run.log.ticks = run.ticks += plain;
  }
}

void Simulation::advanceTo(double time) {
  body_->stopAsked = false;
  body_->advance(time);
  body_->look();
  Run& run = body_->run;
  run.tickBaseTime = run.time, run.tickBase = run.ticks;
}

void Simulation::tick(std::int64_t count) {
  body_->stopAsked = false;
  body_->ticks(count);
}

}  // namespace tyg

// How a simulation advances from one stop time to the next and from tick to tick, with its pushes beginning and ending.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/forces/terms/contact.h"
#include "core/scene/bodies.h"
#include "core/simulation/simulation_impl.h"

namespace tyg {
namespace {

constexpr double kSameTime = 1e-9;  // of dt: stop times closer than this are one
/// Evaluations of all particles between two questions to the observer: a tenth of a second.
constexpr std::int64_t kWorkBetweenQuestions = std::int64_t{1} << 24;
/// Fused steps need as many at once to keep two threads in step.
constexpr std::int64_t kFewestFused = 16;

/// How much the steps of a method take of what damping would. Steps of its own choice let fast waves jitter within the
/// tolerance.
Alarm::Taken takenBy(const Method& method, bool stepsFreely) {
  const bool hasLimit = method.stableStep != nullptr || method.stableStepOfScene != nullptr;
  if (stepsFreely || !hasLimit) return Alarm::Taken::Unknown;
  const bool dampingLimits = method.stableStep != nullptr && std::isfinite(method.stableStep(0, 1));
  return dampingLimits ? Alarm::Taken::AsMuch : Alarm::Taken::Less;
}

}  // namespace

bool Simulation::Impl::halted() const {
  return (stopAsked && !finishing) || run.energies.gaveUp() ||
         (run.energies.status() != Status::Ok && !settings.keepGoing);
}

std::int64_t Simulation::Impl::stepsToCheck() const { return kStepsBetweenChecks - run.steps % kStepsBetweenChecks; }

std::int64_t Simulation::Impl::stepsAtOnce() const { return run.energies.suspects() ? 1 : stepsToQuestion(); }

/// Up to the next energy check, but for large sheets no more than the observer can wait for.
std::int64_t Simulation::Impl::stepsToQuestion() const {
  if (!observer) return stepsToCheck();
  const int evaluations = run.method->evaluationsPerStep;
  const std::int64_t work = std::int64_t{sheet.count()} * std::max(evaluations, 1);
  const std::int64_t fewest = evaluations == 1 ? kFewestFused : 1;
  return std::min(stepsToCheck(), std::max(fewest, kWorkBetweenQuestions / work));
}

void Simulation::Impl::askObserver() {
  if (observer && !observer()) stopAsked = true;
}

/// Times closer than a billionth of dt are the same. Where dt is longer than the run it is a billionth of the run
/// instead: a billionth of a huge dt could be longer than the run, and all of its times would be the same.
Instant Simulation::Impl::now() const {
  return {run.clock.time(), kSameTime * std::min(run.clock.dt(), scene.duration), run.clock.ticks()};
}

double Simulation::Impl::nextEdge(double end) const {
  const double edge = timetable.nextEdge(now(), run.pushes.nextEdge(now(), end));
  if (!(scene.tear.toughness > 0)) return edge;
  const double dt = run.clock.dt();
  const double next = run.ticksSince + (std::floor(ticksSoFar() + kSameTime) + 1) * dt;
  return next < edge - now().sameTime ? next : edge;
}

/// Ticks from where they count for tears, which need not be whole ones.
double Simulation::Impl::ticksSoFar() const { return (run.clock.time() - run.ticksSince) / run.clock.dt(); }

bool Simulation::Impl::mayTearNow() const {
  constexpr double kSameTick = 1e-6;
  return scene.tear.toughness > 0 && run.clock.time() > 0 &&
         std::abs(ticksSoFar() - std::round(ticksSoFar())) < kSameTick;
}

/// What begins or ends now does so.
void Simulation::Impl::switchWhatActs() {
  bool changes = run.pushes.switchAt(now(), *backend);
  if (changes) applyPushes();
  if (timetable.isEdge(now())) {
    checkSupply();
    cutWhatIsDue();
    run.pins.switchAt(scene, sheet, now(), *backend);
    applyTimetable();
    checkSupply();
    followPower();
    changes = true;
  }
  if (mayTearNow()) tearWhatIsTooLong();
  if (changes) backend->reset();
}

/// Accounts for `count` steps of h that ended at `timeAfter`; they must not pass over an energy check.
void Simulation::Impl::finishSteps(double h, int count, double timeAfter) {
  run.clock.moveTo(timeAfter);
  run.largestStep = std::max(run.largestStep, h);
  run.steps += count;
  run.energies.expect(forcing, h);
  if (run.energies.suspects()) {
    const Power power = backend->power(timeAfter);
    run.energies.sample(power.lost), checkSupply(power);
  }
  if (run.steps % kStepsBetweenChecks != 0) {
    if (stepsToQuestion() < stepsToCheck()) askObserver();
    return;
  }
  const Alarm::Taken taken = takenBy(*run.method, stepsFreely());
  const Power power = taken == Alarm::Taken::Unknown ? powerToSupply() : backend->power(timeAfter);
  checkSupply(power);
  run.energies.lose(power.lost, timeAfter, taken);
  run.largestSpeed = std::max(run.largestSpeed, approach());
  run.energies.check(sample(power));
  askObserver();
}

/// `steps` steps, the first of which begins now, and the last of which ends at `end`.
void Simulation::Impl::advance(std::int64_t steps, StepTimes times, double end) {
  for (std::int64_t done = 0; done < steps && !halted();) {
    const auto some = std::min(steps - done, stepsAtOnce());
    backend->steps(times, int(some));
    done += some;
    times.first += some;
    finishSteps(times.h, int(some), done == steps ? end : times.at(0));
  }
}

bool Simulation::Impl::bodiesMove() const {
  return std::ranges::any_of(scene.bodies, [&](const Body& body) {
    return motionOf(scene, body, run.clock.time(), now().sameTime).velocity != Vec3{};
  });
}

double Simulation::Impl::approach() const {
  if (scene.bodies.empty()) return 0;
  double ofBodies = 0;
  for (const Body& body : scene.bodies) {
    const Vec3 velocity = motionOf(scene, body, run.clock.time(), now().sameTime).velocity;
    ofBodies = std::max(ofBodies, std::hypot(velocity.x, velocity.y, velocity.z));
  }
  return backend->largestSpeed() + ofBodies;
}

/// How long a step of the method's own choice may be without leaping over a body, s.
double Simulation::Impl::longestFreeStep() const {
  if (scene.bodies.empty()) return std::numeric_limits<double>::infinity();
  double speed = backend->largestSpeed();
  for (const Move& move : scene.moves) {
    if (!move.body.empty()) speed += std::hypot(move.velocity.x, move.velocity.y, move.velocity.z);
  }
  return stepThatMeetsBodies(scene, speed, run.pushes.largestForce(scene) / sheet.particleMass);
}

/// Steps of the method's own choice. Where these become so short that the run would not end, the tolerance is below
/// what rounding leaves of the numbers: the run advances no further. A scene for fixed steps may name any tolerance.
void Simulation::Impl::advanceFreely(double stop) {
  const double tolerance = usedTolerance(scene);
  while (!halted() && run.clock.time() < stop) {
    const double most = stop - run.clock.time();
    const double taken = backend->stepWithin(run.clock.time(), std::min(most, longestFreeStep()), tolerance);
    finishSteps(taken, 1, taken == most ? stop : run.clock.time() + taken);
    if (most > kMostSteps * taken) run.energies.giveUp(run.clock.time());
  }
}

/// To the next stop, in steps of the method's own choice or in equal steps of at most dt.
void Simulation::Impl::advanceSegment(double stop) {
  switchWhatActs();
  if (stepsFreely()) return advanceFreely(stop);
  const double span = stop - run.clock.time();
  const double steps = std::max(1.0, std::ceil(span / run.clock.dt() - kSameTime));
  if (steps > kMostSteps) {
    throw InputError(fmt::format("dt: found {:g} steps to the next stop, allowed: up to 1e15", steps));
  }
  advance(std::int64_t(steps), {run.clock.time(), 0, span / steps}, stop);
}

void Simulation::Impl::runTo(double end) {
  while (!halted() && run.clock.time() < end - now().sameTime) advanceSegment(nextEdge(end));
}

/// One tick, whatever begins or ends in it. Of steps of the method's own choice there may be millions in a tick: it is
/// done whole or, stopped, not at all. The few of dt that a push's edge leaves in a tick are all done.
void Simulation::Impl::runTick() {
  std::optional<Checkpoint> before;
  if (observer && stepsFreely()) before = checkpoint();
  applyDueEvents();
  const double end = run.clock.tickEnd();
  if (nextEdge(end) == end && !stepsFreely()) {
    switchWhatActs();
    advance(1, run.clock.stepTimes(), end);
  } else {
    finishing = !stepsFreely();
    runTo(end);
    finishing = false;
  }
  if (before && stopAsked && run.clock.time() < end - now().sameTime) return goBackTo(*before);
  run.clock.endTicks(1);
}

/// How many of the next ticks, up to `most`, are one step each with nothing beginning or ending after the first.
std::int64_t Simulation::Impl::plainTicks(std::int64_t most) const {
  if (stepsFreely() || scene.tear.toughness > 0) return 0;
  most = run.replay.ticksToNext(run.clock.ticks(), std::min(most, stepsAtOnce()));
  most = run.pushes.ticksToEdge(run.clock.ticks(), most);
  // Half a tick away from the edge of a scene's push there is no doubt about the tick that it lies in.
  const double edge = nextEdge(run.clock.tickEnd(most)) - run.clock.dt() / 2;
  while (most > 0 && run.clock.tickEnd(most - 1) > edge) --most;
  return most;
}

/// The same as that many single ticks, to the last bit, with the method's steps in one call where nothing comes between
/// them.
void Simulation::Impl::runTicks(std::int64_t count) {
  stopAsked = false;
  const std::int64_t end = run.clock.ticks() + count;
  while (run.clock.ticks() < end && !halted()) {
    applyDueEvents();
    const std::int64_t plain = plainTicks(end - run.clock.ticks());
    if (plain < 2) {
      runTick();
    } else {
      switchWhatActs();
      backend->steps(run.clock.stepTimes(), int(plain));
      finishSteps(run.clock.dt(), int(plain), run.clock.tickEnd(plain - 1));
      run.clock.endTicks(plain);
    }
    run.log.ticks = run.clock.ticks();
  }
  applyDueEvents();  // a record may end with what happened after its last tick: a particle that is pinned has stopped
}

}  // namespace tyg

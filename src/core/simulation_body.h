// The inside of a simulation, for simulation.cpp alone: stop times and ticks, pushes that begin and end, the alarm, the
// log. Must not know: windows, files, clocks; what moves is in moving_sheet.cpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "core/alarm.h"
#include "core/moving_sheet.h"
#include "core/run_memory.h"
#include "core/world.h"
#include "tyg/simulation.h"
#include "tyg/workers.h"

namespace tyg {

inline constexpr std::int64_t kStepsBetweenLooks = 64;
inline constexpr double kSameTime = 1e-9;   // of dt: stop times closer than this are one
inline constexpr double kMostSteps = 1e15;  // of one run: more would not end, and could not be counted

inline double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

struct Simulation::Body {
  Scene scene;
  const Scene started;
  Sheet sheet;
  Settings settings;
  Workers workers;
  std::unique_ptr<MovingSheet> moving;
  std::optional<Run> runStorage;
  std::span<const Method> replayMethods;
  std::function<bool()> observer;
  bool stopAsked = false;
  bool finishing = false;  // a tick that is done whole whoever asks to stop
  double forcing = 0;      // J/s2, see Alarm::expect

  Body(Scene wanted, const Method& method, const Settings& asked)
      : scene(std::move(wanted)),
        started(scene),
        sheet(makeSheet(scene)),
        settings(asked),
        workers(asked.threads > 0 ? asked.threads : defaultThreads(sheet.count())),
        moving(makeMovingSheet(scene, sheet, method, workers, asked.ledger)) {
    const StoredEnergy start = moving->energy();
    runStorage.emplace(makeAlarm(scene, sheet, start));
    Run& r = run();
    r.method = &method;
    r.dt = scene.dt;
    r.startHeight = start.gravitational;
    r.startSum = start.kinetic + start.elastic;
    r.ledger = asked.ledger;
    for (const Push& push : scene.pushes) {
      TimedPush timed;
      timed.particle = particleAt(sheet, push.particle);
      timed.force = push.force;
      timed.begin = push.at;
      timed.end = push.at + push.duration;
      r.pushes.push_back(timed);
    }
    r.log = beginLog(scene, method.name);
    applyPushes();
    look();
  }

  Run& run() { return *runStorage; }
  [[nodiscard]] const Run& run() const { return *runStorage; }

  [[nodiscard]] double work() const {
    double sum = run().finishedWork;
    for (const TimedPush& push : run().pushes) {
      if (push.acting) sum += dot(push.force, moving->position(push.particle) - push.from);
    }
    return sum;
  }

  [[nodiscard]] double ledgerSum(const StoredEnergy& energy) const {
    return energy.kinetic + energy.elastic + energy.gravitational + moving->dissipated() - work();
  }

  void followLedger(bool on) {
    settings.ledger = on;
    moving->trackDissipation(on);
    if (run().ledger == on) return;
    run().startSum = ledgerSum(look());
    run().ledger = on;
  }

  StoredEnergy look() {
    Run& r = run();
    StoredEnergy energy = moving->energy();
    energy.gravitational -= r.startHeight;
    r.maxStretch = std::max(r.maxStretch, energy.maxStretch);
    const Status now = r.alarm.look(energy, work());
    if (now != Status::Ok && r.status == Status::Ok) r.alarmTime = r.time;
    r.status = std::max(r.status, now);
    return energy;
  }

  [[nodiscard]] bool standing() const {
    return (stopAsked && !finishing) || run().stuck || (run().status != Status::Ok && !settings.keepGoing);
  }

  /// Accounts for `steps` steps of h that ended at `timeAfter`; they must not pass over a look.
  void count(double h, int steps, double timeAfter) {
    Run& r = run();
    r.time = timeAfter;
    r.largestStep = std::max(r.largestStep, h);
    r.steps += steps;
    r.alarm.expect(forcing, h);
    if (r.steps % kStepsBetweenLooks == 0) {
      r.alarm.lose(keepsTheBalance() ? moving->lossPower() : 0, r.time);
      look();
      if (observer && !observer()) stopAsked = true;
    }
  }

  /// `steps` steps of h from now on, the last of which ends at `end`.
  void walk(std::int64_t steps, double h, double end) {
    const double from = run().time;
    for (std::int64_t done = 0; done < steps && !standing();) {
      const auto some = std::min(steps - done, kStepsBetweenLooks - run().steps % kStepsBetweenLooks);
      moving->steps(h, int(some));
      done += some;
      count(h, int(some), done == steps ? end : from + double(done) * h);
    }
  }

  /// s: stop times closer than this are one. A step longer than the run does not make the whole run one moment.
  [[nodiscard]] double sameTime() const { return kSameTime * std::min(run().dt, scene.duration); }

  [[nodiscard]] bool shouldAct(const TimedPush& push) const {
    const Run& r = run();
    if (push.byHand) return push.firstTick <= r.ticks && r.ticks < push.endTick;
    const double soon = r.time + sameTime();
    return push.begin <= soon && soon < push.end;
  }

  /// Lets pushes begin and end that do so now; where any does, the force jumps.
  void switchPushes() {
    Run& r = run();
    bool jump = false;
    for (TimedPush& push : r.pushes) {
      if (shouldAct(push) == push.acting) continue;
      jump = true;
      const Vec3 here = moving->position(push.particle);
      if (push.acting) r.finishedWork += dot(push.force, here - push.from);
      push.from = here;
      push.acting = !push.acting;
    }
    if (!jump) return;
    applyPushes();
    moving->reset();
    std::erase_if(r.pushes, [&](const TimedPush& push) { return push.byHand && push.endTick <= r.ticks; });
  }

  void applyPushes() {
    moving->clearPushes();
    const double mass = sheet.particleMass;
    double root = std::sqrt(sheet.count() * mass * dot(scene.gravity, scene.gravity));
    for (const TimedPush& push : run().pushes) {
      if (!push.acting) continue;
      moving->addPush(push.particle, push.force);
      root += std::sqrt(dot(push.force, push.force) / mass);  // a sum of vectors is no longer than their lengths
    }
    forcing = root * root;
  }

  /// The first edge of a scene's push after now, or `end` where none comes before it.
  [[nodiscard]] double nextStop(double end) const {
    const Run& r = run();
    const double tolerance = sameTime();
    double stop = end;
    for (const TimedPush& push : r.pushes) {
      if (push.byHand) continue;
      for (const double edge : {push.begin, push.end}) {
        if (edge > r.time + tolerance && edge < stop - tolerance) stop = edge;
      }
    }
    return stop;
  }

  /// Whether the method takes from fast waves about what damping should. One that holds whatever the damping takes
  /// less, and steps of a method's own choice let fast waves jitter within the tolerance.
  [[nodiscard]] bool keepsTheBalance() const {
    const auto stableStep = run().method->stableStep;
    return !stepsFreely() && stableStep != nullptr && std::isfinite(stableStep(0, 1));
  }

  /// Whether the method chooses its own steps. With tolerance 0 an adaptive method takes those of dt, for studies.
  [[nodiscard]] bool stepsFreely() const { return run().method->adaptive && scene.tolerance > 0; }

  /// For a method whose steps have become so short that the run would not end: its tolerance is below what rounding
  /// leaves of the numbers.
  void giveUp() {
    Run& r = run();
    if (r.status == Status::Ok) r.alarmTime = r.time;
    r.status = Status::NotFinite;
    r.stuck = true;
  }

  /// Equal steps of at most dt to the next stop, or steps of the method's own choice.
  void advanceSegment(double stop) {
    Run& r = run();
    switchPushes();
    if (stepsFreely()) {
      while (!standing() && r.time < stop) {
        const double most = stop - r.time, taken = moving->stepWithin(most, scene.tolerance);
        count(taken, 1, taken == most ? stop : r.time + taken);
        if (most > kMostSteps * taken) giveUp();
      }
      return;
    }
    const double span = stop - r.time;
    const double steps = std::max(1.0, std::ceil(span / r.dt - kSameTime));
    if (steps > kMostSteps) {
      throw InputError("dt: found " + std::to_string(steps) + " steps to the next stop, allowed: up to 1e15");
    }
    walk(std::int64_t(steps), span / steps, stop);
  }

  void advance(double end) {
    while (!standing() && run().time < end - sameTime()) advanceSegment(nextStop(end));
  }

  /// s, when the tick ends that is `ahead` after this one.
  [[nodiscard]] double tickEnd(std::int64_t ahead) const {
    const Run& r = run();
    return r.tickBaseTime + double(r.ticks + 1 + ahead - r.tickBase) * r.dt;
  }

  void tick() {
    // Of steps of the method's own choice there may be millions in a tick: it is done whole or, stopped, not at all.
    // The few of dt that a push's edge leaves in a tick are all done.
    std::optional<Saved> before;
    if (observer && stepsFreely()) before = save();
    playScript();
    const double end = tickEnd(0);
    if (nextStop(end) == end && !stepsFreely()) {
      switchPushes();
      walk(1, run().dt, end);
    } else {
      finishing = !stepsFreely();
      advance(end);
      finishing = false;
    }
    if (before && stopAsked && run().time < end - sameTime()) return restore(*before);
    run().log.ticks = ++run().ticks;
  }

  /// Everything that changes as time passes.
  struct Saved {
    Run run;
    World world;
    std::unique_ptr<MovingSheet::Moment> moment;
  };
  [[nodiscard]] Saved save() const { return {run(), worldOf(scene), moving->save()}; }
  void restore(const Saved& saved) {
    if (saved.world != worldOf(scene)) {
      setWorld(scene, saved.world);
      moving->useWorld(*saved.run.method);
    }
    run() = saved.run;
    moving->restore(*saved.moment);
    applyPushes();
    if (run().ledger != settings.ledger) followLedger(settings.ledger);
  }

  /// How many of the next ticks, up to `most`, are one step each with nothing beginning or ending after the first.
  [[nodiscard]] std::int64_t plainTicks(std::int64_t most) const {
    const Run& r = run();
    if (stepsFreely()) return 0;
    most = std::min(most, kStepsBetweenLooks - r.steps % kStepsBetweenLooks);
    if (r.scriptNext < r.script.size()) most = std::min(most, r.script[r.scriptNext].tick - r.ticks);
    for (const TimedPush& push : r.pushes) {
      for (const std::int64_t edge : {push.firstTick, push.endTick}) {
        if (push.byHand && edge > r.ticks) most = std::min(most, edge - r.ticks);
      }
    }
    // Half a tick away from the edge of a scene's push there is no doubt about the tick that it lies in.
    const double edge = nextStop(tickEnd(most)) - r.dt / 2;
    while (most > 0 && tickEnd(most - 1) > edge) --most;
    return most;
  }

  /// The same as that many single ticks, to the last bit, with the method's steps in one call where nothing comes
  /// between them.
  void tick(std::int64_t count) {
    const std::int64_t end = run().ticks + count;
    while (run().ticks < end && !standing()) {
      playScript();
      const std::int64_t plain = plainTicks(end - run().ticks);
      if (plain < 2) {
        tick();
        continue;
      }
      switchPushes();
      moving->steps(run().dt, int(plain));
      this->count(run().dt, int(plain), tickEnd(plain - 1));
      run().log.ticks = run().ticks += plain;
    }
  }

  void note(LogEvent event) {
    event.tick = run().ticks;
    run().log.events.push_back(std::move(event));
  }

  void push(int particle, const Vec3& force, int ticks) {
    Run& r = run();
    TimedPush timed;
    timed.particle = particle;
    timed.force = force;
    timed.firstTick = r.ticks, timed.endTick = r.ticks + ticks;
    timed.byHand = true;
    r.pushes.push_back(timed);
    note({.kind = LogEvent::Kind::Push, .particle = particle, .force = force, .ticks = ticks});
  }

  void useMethod(const Method& method) {
    moving->useMethod(method);  // first: it may refuse the scene
    run().method = &method;
    note({.kind = LogEvent::Kind::Method, .method = std::string(method.name)});
  }

  void useStep(double dt) {
    Run& r = run();
    r.tickBaseTime = r.time, r.tickBase = r.ticks;
    r.dt = dt;
    note({.kind = LogEvent::Kind::Step, .dt = dt});
  }

  /// Gravitational energy counts from the start shape, and the alarm learns anew what a large energy is: what the
  /// change itself adds is nobody's fault.
  void changeWorld(const LogEvent& event) {
    const World before = worldOf(scene);
    World after = before;
    change(after, event);
    const double stored = storedNow();
    setWorld(scene, after);
    try {
      moving->useWorld(*run().method);
    } catch (...) {
      setWorld(scene, before);
      throw;
    }
    applyPushes();
    Run& r = run();
    r.startHeight = makeMovingSheet(scene, sheet, *r.method, workers, false)->energy().gravitational;
    r.finishedWork += storedNow() - stored;
    r.alarm = makeAlarm(scene, sheet, moving->energy());
    look();
    note(event);
  }
  /// J.
  [[nodiscard]] double storedNow() const {
    const StoredEnergy energy = moving->energy();
    return energy.elastic + energy.gravitational - run().startHeight;
  }

  [[nodiscard]] const Method& replayMethod(std::string_view name) const {
    const auto found = std::find_if(replayMethods.begin(), replayMethods.end(),
                                    [&](const Method& method) { return method.name == name; });
    if (found == replayMethods.end())
      throw InputError("replay: found the unknown method \"" + std::string(name) + "\"");
    return *found;
  }

  void playScript() {
    Run& r = run();
    while (r.scriptNext < r.script.size() && r.script[r.scriptNext].tick <= r.ticks) {
      const LogEvent event = r.script[r.scriptNext++];
      play(event);
    }
  }

  void play(const LogEvent& event) {
    switch (event.kind) {
      case LogEvent::Kind::Push:
        return push(event.particle, event.force, event.ticks);
      case LogEvent::Kind::Method:
        return useMethod(replayMethod(event.method));
      case LogEvent::Kind::Step:
        return useStep(event.dt);
      default:
        return changeWorld(event);
    }
  }
};

}  // namespace tyg

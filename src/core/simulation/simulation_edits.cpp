// What is done to a simulation from outside between its ticks: pushes, other methods, steps and worlds, and the replay
// of a log of them.
#include <algorithm>

#include "core/simulation/simulation_body.h"

namespace tyg {

void Simulation::Body::note(LogEvent event) {
  event.tick = run.ticks;
  run.log.events.push_back(std::move(event));
}

void Simulation::Body::push(int particle, const Vec3& force, int ticks) {
  run.pushes.add(particle, force, run.ticks, run.ticks + ticks);
  note({.kind = LogEvent::Kind::Push, .particle = particle, .force = force, .ticks = ticks});
}

void Simulation::Body::useMethod(const Method& method) {
  moving->useMethod(method);  // first: it may refuse the scene
  run.method = &method;
  note({.kind = LogEvent::Kind::Method, .method = std::string(method.name)});
}

void Simulation::Body::useStep(double dt) {
  run.tickBaseTime = run.time, run.tickBase = run.ticks;
  run.dt = dt;
  note({.kind = LogEvent::Kind::Step, .dt = dt});
}

/// Gravitational energy counts from the start shape, and the alarm learns anew what a large energy is: what the change
/// itself adds is nobody's fault.
void Simulation::Body::changeWorld(const LogEvent& event) {
  const World before = worldOf(scene);
  World after = before;
  change(after, event);
  const auto storedNow = [this] {
    const StoredEnergy energy = moving->energy();
    return energy.elastic + energy.gravitational - run.startHeight;
  };
  const double stored = storedNow();
  setWorld(scene, after);
  try {
    moving->useWorld();
  } catch (...) {
    setWorld(scene, before);
    throw;
  }
  forcing = run.pushes.forcing(scene, sheet);
  if (after.gravity != before.gravity) run.startHeight = moving->startHeight();
  run.pushes.addWork(storedNow() - stored);
  run.alarm = makeAlarm(scene, sheet, moving->energy());
  look();
  note(event);
}

const Method& Simulation::Body::replayMethod(std::string_view name) const {
  const auto found = std::ranges::find(replayMethods, name, &Method::name);
  if (found == replayMethods.end()) throw InputError("replay: found the unknown method \"" + std::string(name) + "\"");
  return *found;
}

void Simulation::Body::play(const LogEvent& event) {
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

void Simulation::Body::playScript() {
  while (run.scriptNext < run.script.size() && run.script[run.scriptNext].tick <= run.ticks) {
    const LogEvent event = run.script[run.scriptNext++];
    play(event);
  }
}

void Simulation::push(int particle, const Vec3& force, int ticks) {
  if (particle < 0 || particle >= body_->sheet.count() || ticks < 1) {
    throw InputError("push: found particle " + std::to_string(particle) + " for " + std::to_string(ticks) +
                     " ticks, allowed: particle 0 to " + std::to_string(body_->sheet.count() - 1) +
                     ", at least one tick");
  }
  body_->push(particle, force, ticks);
}

void Simulation::useMethod(const Method& method) { body_->useMethod(method); }

void Simulation::useStep(double dt) {
  if (!(dt > 0) || !std::isfinite(dt)) throw InputError("dt: found " + std::to_string(dt) + ", allowed: above 0");
  body_->useStep(dt);
}

void Simulation::useWorld(const Scene& scene) {
  for (const LogEvent& event : changesBetween(worldOf(body_->scene), worldOf(scene))) body_->changeWorld(event);
}

void Simulation::apply(const LogEvent& event, std::span<const Method> methods) {
  body_->replayMethods = methods;
  body_->play(event);
}

void Simulation::replay(const PushLog& log, std::span<const Method> methods) {
  refuseUnfitLog(log, body_->run.log);
  body_->replayMethods = methods;
  for (const LogEvent& event : log.events) {
    if (event.kind == LogEvent::Kind::Method) (void)body_->replayMethod(event.method);
  }
  body_->run.script = log.events;
  body_->run.scriptNext = 0;
}

}  // namespace tyg

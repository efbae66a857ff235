// What each kind of event does to a simulation, between two of its ticks.
#include <fmt/core.h>

#include <cmath>

#include "core/forces/parameter.h"
#include "core/scene/bodies.h"
#include "core/scene/scene_range.h"
#include "core/simulation/simulation_impl.h"
#include "util/text.h"

namespace tyg {

void Simulation::Impl::apply(const EventAction& action, std::span<const Method> methods) {
  std::visit([&](const auto& event) { perform(event, methods); }, action);  // first: it may refuse
  run.log.events.push_back({run.clock.ticks(), action});
}

void Simulation::Impl::applyDueEvents() {
  while (const Event* event = run.replay.takeDue(run.clock.ticks())) apply(event->action, run.replay.methods());
}

void Simulation::Impl::perform(const PushEvent& push, std::span<const Method> /*methods*/) {
  if (push.particle < 0 || push.particle >= sheet.count() || push.ticks < 1) {
    throw InputError(fmt::format("push: found particle {} for {} ticks, allowed: particle 0 to {}, at least one tick",
                                 push.particle, push.ticks, sheet.count() - 1));
  }
  run.pushes.add(sheet, push.particle, push.force, run.clock.ticks(), run.clock.ticks() + push.ticks);
}

void Simulation::Impl::perform(const MethodEvent& change, std::span<const Method> methods) {
  const Method& method = methodNamed(change.method, methods);
  backend->useMethod(method);
  run.method = &method;
}

void Simulation::Impl::perform(const StepEvent& change, std::span<const Method> /*methods*/) {
  if (!(change.dt > 0) || !std::isfinite(change.dt)) {
    throw InputError(fmt::format("dt: found {:g}, allowed: above 0", change.dt));
  }
  run.clock.useStep(change.dt);
}

/// What has no natural zero counts from the start shape, and the alarm learns anew what a large energy is: the energy
/// that the change itself adds is not an error of the method, and counts as work.
void Simulation::Impl::perform(const WorldEvent& change, std::span<const Method> /*methods*/) {
  const Parameter* parameter = findParameter(change.parameter);
  if (parameter == nullptr) {
    throw InputError(fmt::format("world: found the parameter '{}', allowed: {}", change.parameter,
                                 joined(liveParameters(), &Parameter::key)));
  }
  const Vec3 before = parameter->get(scene);
  const double mechanical = run.energies.mechanical(backend->energy(run.clock.time()));
  checkSupply();
  parameter->set(scene, change.value);
  try {
    refuseExtremeParameters(scene);
    refuseUnfitBodies(scene);
    backend->useLiveParameters();
  } catch (...) {
    parameter->set(scene, before);
    throw;
  }
  applyTimetable();
  checkSupply();
  forcing = run.pushes.forcing(scene, sheet);
  const StoredEnergy energy = backend->energy(run.clock.time());
  run.energies.begin(scene, sheet, backend->startEnergy(), energy);
  run.pushes.addWork(run.energies.mechanical(energy) - mechanical);
  run.energies.check(sample());
}

void Simulation::Impl::applyTimetable() {
  backend->act(actingAt(scene, now()));
  if (!scene.moves.empty()) backend->movePins(run.pins.moving());
}

void Simulation::Impl::applyPushes() {
  run.pushes.applyTo(*backend);
  forcing = run.pushes.forcing(scene, sheet);
}

}  // namespace tyg

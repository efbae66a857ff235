// What each kind of event does to a simulation, between two of its ticks.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/forces/parameter.h"
#include "core/scene/bodies.h"
#include "core/scene/scene_range.h"
#include "core/simulation/live_parameters.h"
#include "core/simulation/simulation_impl.h"
#include "util/text.h"

namespace tyg {

void Simulation::Impl::apply(const EventAction& action, std::span<const Method> methods) {
  std::visit([&](const auto& event) { perform(event, methods); }, action);  // first: it may refuse
  run.log.events.push_back({run.clock.ticks(), action});
}

/// Another tolerance is at most what bodies allow. A change may bring about another one that comes later: without a
/// wind there are no gusts.
void Simulation::Impl::useLiveParameters(Scene wanted) {
  if (wanted.tolerance != scene.tolerance) wanted.tolerance = std::min(wanted.tolerance, largestTolerance(wanted));
  for (const WorldEvent& change : changesBetween(scene, wanted)) {
    if (findParameter(change.parameter)->get(scene) != change.value) apply(change, {});
  }
}

void Simulation::Impl::applyDueEvents() {
  while (const Event* event = run.replay.takeDue(run.clock.ticks())) apply(event->action, run.replay.methods());
}

void Simulation::Impl::perform(const PushEvent& push, std::span<const Method> /*methods*/) {
  refuseOutside("push", push.particle);
  if (push.ticks < 1) {
    throw InputError(fmt::format("push: found {} ticks, allowed: at least one tick", push.ticks));
  }
  run.pushes.add(sheet, push.particle, push.force, run.clock.ticks(), run.clock.ticks() + push.ticks);
}

void Simulation::Impl::perform(const MethodEvent& change, std::span<const Method> methods) {
  const Method& method = methodNamed(change.method, methods);
  backend->useMethod(method);
  run.method = &method;
  run.energies.useOrder(method.order);
}

void Simulation::Impl::perform(const StepEvent& change, std::span<const Method> /*methods*/) {
  if (!(change.dt > 0) || !std::isfinite(change.dt)) {
    throw InputError(fmt::format("dt: found {:g}, allowed: above 0", change.dt));
  }
  run.clock.useStep(change.dt);
  run.ticksSince = run.clock.time();
}

void Simulation::Impl::refuseWithoutEffect(const Parameter& parameter, const Vec3& value) const {
  const auto exists = [&](const Parameter& each) { return each.exists == nullptr || each.exists(scene); };
  if (!exists(parameter)) {
    std::vector<std::string_view> known;
    for (const Parameter& each : liveParameters()) {
      if (exists(each)) known.push_back(each.key);
    }
    throw InputError(fmt::format("world: found the parameter '{}', which this scene has nothing for, allowed: {}",
                                 parameter.key, joined(known)));
  }
  if (parameter.key == "run.tolerance" && value.x > largestTolerance(scene)) {
    throw InputError(
        fmt::format("world: found a tolerance of {:g} m, allowed: {}", value.x, largestToleranceInWords(scene)));
  }
}

/// What has no natural zero counts from the start shape, and the alarm learns anew what a large energy is: the energy
/// that the change itself adds is not an error of the method, and counts as work.
void Simulation::Impl::perform(const WorldEvent& change, std::span<const Method> /*methods*/) {
  const Parameter* parameter = findParameter(change.parameter);
  if (parameter == nullptr) {
    throw InputError(fmt::format("world: found the parameter '{}', allowed: {}", change.parameter,
                                 joined(liveParameters(), &Parameter::key)));
  }
  refuseWithoutEffect(*parameter, change.value);
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

void Simulation::Impl::refuseOutside(std::string_view event, int particle) const {
  if (particle >= 0 && particle < sheet.count()) return;
  throw InputError(fmt::format("{}: found particle {}, allowed: particle 0 to {}", event, particle, sheet.count() - 1));
}

/// A particle that is pinned stops at once: what it had of kinetic energy is taken by the pin.
void Simulation::Impl::perform(const PinEvent& change, std::span<const Method> /*methods*/) {
  refuseOutside("pin", change.particle);
  const bool wasPinned = std::ranges::binary_search(sheet.pins, change.particle);
  run.changes.pin(change.particle, change.pinned);
  useSheet();
  if (change.pinned && !wasPinned) run.pins.stop(change.particle, sheet, *backend);
  movePins();
}

void Simulation::Impl::perform(const GrabEvent& grab, std::span<const Method> /*methods*/) {
  refuseOutside("grab", grab.particle);
  const Vec3& v = grab.velocity;
  if (!std::isfinite(v.x + v.y + v.z)) throw InputError("grab: found a velocity that is not finite, allowed: finite");
  if (run.changes.hold(grab.particle)) useSheet();
  run.pins.hold(grab.particle, v);
  movePins();
}

void Simulation::Impl::perform(const ReleaseEvent& release, std::span<const Method> /*methods*/) {
  refuseOutside("release", release.particle);
  run.pins.release(release.particle);
  if (run.changes.release(release.particle)) useSheet();
  movePins();
}

void Simulation::Impl::perform(const CutEvent& cut, std::span<const Method> /*methods*/) {
  const CutLine& line = cut.line;
  if (!std::isfinite(line.fromColumn + line.fromRow + line.toColumn + line.toRow)) {
    throw InputError("cut: found a place that is not finite, allowed: finite numbers");
  }
  if (line.fromColumn == line.toColumn && line.fromRow == line.toRow) {
    throw InputError("cut: found a cut that ends where it begins, allowed: another end");
  }
  lose([&] { run.changes.cut(line); });
}

template <class Change>
void Simulation::Impl::lose(const Change& change) {
  const double before = backend->energy(run.clock.time()).sum();
  change();
  if (run.changes.sheet().missing == sheet.missing) return;
  useSheet();
  run.cutAway += before - backend->energy(run.clock.time()).sum();
}

/// The springs that come back may be stretched by now: that energy is work.
void Simulation::Impl::perform(const MendEvent& mend, std::span<const Method> /*methods*/) {
  const double before = backend->energy(run.clock.time()).sum();
  run.changes.mend(mend.cuts);
  useSheet();
  run.pushes.addWork(backend->energy(run.clock.time()).sum() - before);
}

void Simulation::Impl::cutWhatIsDue() {
  if (!scene.cuts.empty()) lose([&] { run.changes.cutOfScene(scene, now()); });
}

void Simulation::Impl::tearWhatIsTooLong() {
  const double strain = strainThatTears(scene);
  if (!std::isfinite(strain)) return;
  const std::vector<SpringEnds> tooLong = backend->longerThan((1 + strain) * sheet.spacing);
  if (!tooLong.empty()) lose([&] { run.changes.tear(tooLong); });
}

void Simulation::Impl::useSheet() {
  checkSupply();  // pins feel no wind, and a cell that is cut is none any more
  sheet = run.changes.sheet();
  backend->useSheet(*run.method);
  run.pushes.useSheet(sheet, *backend);
  applyPushes();
  if (run.pins.any()) backend->movePins(run.pins.moving());
  checkSupply();
}

/// What moves pins, now that it is said anew.
void Simulation::Impl::movePins() {
  run.pins.switchAt(scene, sheet, now(), *backend);
  applyTimetable();
  backend->reset();
}

void Simulation::Impl::applyTimetable() {
  backend->act(actingAt(scene, now()));
  backend->movePins(run.pins.moving());
}

void Simulation::Impl::applyPushes() {
  run.pushes.applyTo(*backend);
  forcing = run.pushes.forcing(scene, sheet);
}

}  // namespace tyg

// Makes each leaner scene by copying the scene and changing one thing in it.
#include "study/diet/diet_changes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "core/forces/terms/contact.h"
#include "core/scene/bodies.h"
#include "study/limits/stability.h"
#include "tyg/methods.h"
#include "tyg/sheet.h"

namespace tyg {
namespace {

constexpr int kFewestSteps = 20;  // of a run: longer ones would leave out sample times

std::vector<Changed> withoutTerm(Scene scene, const ForceTerm& term) {
  if (!hasTerm(scene, term)) return {};
  if (&term == &ContactTerm::kTerm) {
    if (scene.bodies.size() < 2) return {};  // the only body is left out by itself
    return {{"no contact", withoutBodies(std::move(scene))}};
  }
  leaveOut(scene, term);
  if (!(scene.air.density > 0)) scene.winds.clear();  // which blow nothing any more
  return {{fmt::format("no {}", term.name), std::move(scene)}};
}

std::vector<Changed> withUndampedSprings(const Scene& scene) {
  Scene undamped = withoutSpringDamping(scene);
  if (undamped == scene) return {};
  return {{"no spring damping", std::move(undamped)}};
}

/// Of several equal bodies it takes the one at its place, as long as it is there.
std::vector<Changed> withoutThe(const BodyOfScene& which, const Scene& scene) {
  const std::vector<Body>& bodies = scene.bodies;
  if (!touchesBodies(scene)) return {};
  std::size_t index = which.index;
  if (index >= bodies.size() || bodies[index] != which.body) {
    index = std::size_t(std::ranges::find(bodies, which.body) - bodies.begin());
  }
  if (index == bodies.size()) return {};
  return {{"no " + which.words, withoutBody(scene, index)}};
}

std::vector<Changed> withoutFriction(Scene scene) {
  if (!touchesBodies(scene) || !(scene.contact.friction > 0)) return {};
  scene.contact.friction = 0;
  return {{"no friction", std::move(scene)}};
}

std::vector<Changed> withUndampedContact(Scene scene) {
  if (!touchesBodies(scene) || !(scene.contact.damping > 0)) return {};
  scene.contact.damping = 0;
  return {{"no contact damping", std::move(scene)}};
}

std::vector<Changed> inStillAir(Scene scene) {
  if (!(scene.air.density > 0) || scene.winds.empty()) return {};
  scene.winds.clear();
  return {{"no wind", std::move(scene)}};
}

std::vector<Changed> withoutGusts(Scene scene) {
  const auto gusts = [](const Wind& wind) { return wind.gust != Vec3{}; };
  if (!(scene.air.density > 0) || std::ranges::none_of(scene.winds, gusts)) return {};
  for (Wind& wind : scene.winds) wind.gust = {}, wind.wavelength = 0;
  return {{"no gusts", std::move(scene)}};
}

std::vector<Changed> onHalfTheSheet(const Scene& scene) {
  const int columns = (scene.columns + 1) / 2, rows = (scene.rows + 1) / 2;
  const bool smaller = columns < scene.columns || rows < scene.rows;
  if (!smaller || std::max(columns, rows) < 2) return {};
  Scene half = withSheet(scene, columns, rows);
  if (!fitsBodies(half)) return {};
  return {{fmt::format("sheet {}x{}", columns, rows), std::move(half)}};
}

std::vector<Changed> inFloat(Scene scene) {
  if (scene.precision == Precision::Float) return {};
  scene.precision = Precision::Float;
  return {{"float", std::move(scene)}};
}

std::vector<Changed> withLongerSteps(Scene scene) {
  const Method& method = findMethod(scene.integrator);
  if (method.adaptive) {
    scene.tolerance *= 10;
    if (scene.tolerance > largestTolerance(scene)) return {};
    return {{fmt::format("tolerance {:.2g} m", scene.tolerance), std::move(scene)}};
  }
  const double limit = kShareOfLimit * restLatticeLimit(scene, method), longest = scene.duration / kFewestSteps;
  std::vector<double> steps;
  for (double step = 2 * scene.dt; step <= longest && !(step > limit); step *= 2) steps.push_back(step);
  constexpr double kWorthwhile = 1.1;
  const double last = steps.empty() ? scene.dt : steps.back();
  if (limit > kWorthwhile * last && limit <= longest) steps.push_back(limit);
  if (steps.empty() && 2 * scene.dt <= longest) steps.push_back(2 * scene.dt);
  std::vector<Changed> changes;
  for (const double step : steps) {
    scene.dt = step;
    changes.push_back({fmt::format("step {:.3g} ms", 1000 * scene.dt), scene});
  }
  return changes;
}

std::vector<Changed> byOtherMethods(const Scene& scene) {
  std::vector<Changed> changes;
  for (const Method& method : methods()) {
    if (method.name == scene.integrator || method.adaptive || !method.advisable || !takes(method, scene)) continue;
    const double limit = restLatticeLimit(scene, method);
    if (limit == 0) continue;
    Changed& change = changes.emplace_back(Changed{std::string(method.name), scene});
    change.scene.integrator = method.name;
    if (kShareOfLimit * limit < scene.dt) change.scene.dt = kShareOfLimit * limit;
  }
  return changes;
}

}  // namespace

std::vector<Change> allChanges(const Scene& scene) {
  std::vector<Change> changes;
  const auto addTerms = [&](bool springs) {
    for (const ForceTerm* term : forceTerms()) {
      if (term->mayBeLeftOut && term->family.has_value() == springs) changes.push_back({Change::LeaveOut, term});
    }
  };
  addTerms(true);
  changes.push_back({Change::SpringDamping});
  addTerms(false);
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    changes.push_back({Change::OneBody, nullptr, {scene.bodies[k], k, wordsFor(scene, k)}});
  }
  for (const Change::Kind kind : {Change::Friction, Change::ContactDamping, Change::StillAir, Change::SteadyWind,
                                  Change::HalfSheet, Change::Float, Change::Step, Change::Method}) {
    changes.push_back({kind});
  }
  return changes;
}

std::vector<Changed> changesOf(const Scene& scene, const Change& change) {
  switch (change.kind) {
    case Change::LeaveOut:
      return withoutTerm(scene, *change.term);
    case Change::SpringDamping:
      return withUndampedSprings(scene);
    case Change::OneBody:
      return withoutThe(change.body, scene);
    case Change::Friction:
      return withoutFriction(scene);
    case Change::ContactDamping:
      return withUndampedContact(scene);
    case Change::StillAir:
      return inStillAir(scene);
    case Change::SteadyWind:
      return withoutGusts(scene);
    case Change::HalfSheet:
      return onHalfTheSheet(scene);
    case Change::Float:
      return inFloat(scene);
    case Change::Step:
      return withLongerSteps(scene);
    case Change::Method:
      break;
  }
  return byOtherMethods(scene);
}

bool repeats(const Change& change) {
  return change.kind == Change::HalfSheet || change.kind == Change::Step || change.kind == Change::Method;
}

}  // namespace tyg

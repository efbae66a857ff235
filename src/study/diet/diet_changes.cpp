// Leaner scenes.
#include "study/diet/diet_changes.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "study/limits/stability.h"
#include "tyg/methods.h"
#include "tyg/sheet.h"

namespace tyg {
namespace {

constexpr int kFewestSteps = 20;  // of a run: longer ones would leave out sample times

std::string stepWords(const Scene& scene) {
  std::ostringstream words;
  words.precision(3);
  words << "step " << 1000 * scene.dt << " ms";
  return words.str();
}

std::vector<Changed> withoutFamily(Scene scene, SpringFamily Scene::*family, const char* words) {
  if (!(scene.*family).present()) return {};
  scene.*family = {};
  return {{words, std::move(scene)}};
}

std::vector<Changed> withoutSpringDamping(Scene scene) {
  if (scene.structural.kd == 0 && scene.shear.kd == 0 && scene.bend.kd == 0) return {};
  scene.structural.kd = scene.shear.kd = scene.bend.kd = 0;
  return {{"no spring damping", std::move(scene)}};
}

std::vector<Changed> withoutDrag(Scene scene) {
  if (scene.drag == 0) return {};
  scene.drag = 0;
  return {{"no drag", std::move(scene)}};
}

std::vector<Changed> onHalfTheSheet(const Scene& scene) {
  const int columns = (scene.columns + 1) / 2, rows = (scene.rows + 1) / 2;
  const bool smaller = columns < scene.columns || rows < scene.rows;
  if (!smaller || std::max(columns, rows) < 2) return {};
  const std::string words = "sheet " + std::to_string(columns) + "x" + std::to_string(rows);
  return {{words, withSheet(scene, columns, rows)}};
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
    std::ostringstream words;
    words.precision(2);
    words << "tolerance " << scene.tolerance << " m";
    return {{words.str(), std::move(scene)}};
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
    changes.push_back({stepWords(scene), scene});
  }
  return changes;
}

std::vector<Changed> byOtherMethods(const Scene& scene) {
  std::vector<Changed> changes;
  for (const Method& method : methods()) {
    if (method.name == scene.integrator || method.adaptive || !advisable(method) || !takes(method, scene)) continue;
    const double limit = restLatticeLimit(scene, method);
    if (limit == 0) continue;
    Changed& change = changes.emplace_back(Changed{std::string(method.name), scene});
    change.scene.integrator = method.name;
    if (kShareOfLimit * limit < scene.dt) change.scene.dt = kShareOfLimit * limit;
  }
  return changes;
}

}  // namespace

std::vector<Changed> changesOf(const Scene& scene, Change change) {
  switch (change) {
    case Change::Structural:
      return withoutFamily(scene, &Scene::structural, "no structural");
    case Change::Bend:
      return withoutFamily(scene, &Scene::bend, "no bend");
    case Change::Shear:
      return withoutFamily(scene, &Scene::shear, "no shear");
    case Change::SpringDamping:
      return withoutSpringDamping(scene);
    case Change::Drag:
      return withoutDrag(scene);
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

bool repeats(Change change) {
  return change == Change::HalfSheet || change == Change::Step || change == Change::Method;
}

bool advisable(const Method& method) { return method.name != "report-rk4"; }

}  // namespace tyg

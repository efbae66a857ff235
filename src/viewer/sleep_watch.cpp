// Looks at the kinetic energy first, which is at hand, and at single particles only where that is small enough.
#include "viewer/sleep_watch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/forces/term.h"
#include "core/forces/terms/springs.h"

namespace tyg {
namespace {

/// Does the scene still do something to the cloth, now or later? A steady wind that never ends does not count: the
/// cloth comes to rest in it.
bool somethingIsToCome(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  const auto isToCome = [&](const auto& each) { return each.at + each.duration > simulation.time(); };
  const auto changes = [&](const Wind& wind) {
    const bool isSteady = wind.gust == Vec3{} && wind.at <= simulation.time() && std::isinf(wind.duration);
    return !isSteady && isToCome(wind);
  };
  const auto isCutToCome = [&](const Cut& cut) { return cut.at > simulation.time(); };
  return std::ranges::any_of(scene.cuts, isCutToCome) || std::ranges::any_of(scene.pushes, isToCome) ||
         std::ranges::any_of(scene.moves, isToCome) ||
         (scene.air.density > 0 && std::ranges::any_of(scene.winds, changes));
}

double fastest(const Simulation& simulation) {
  double squared = 0;
  for (int particle = 0; particle < simulation.sheet().count(); ++particle) {
    const Vec3 v = simulation.velocity(particle);
    squared = std::max(squared, v.x * v.x + v.y * v.y + v.z * v.z);
  }
  return std::sqrt(squared);
}

/// A speed, m/s, at which a step moves no particle by more than the rounding of its position.
double speedOfRounding(const Simulation& simulation) {
  constexpr double kRoundings = 8;
  const bool isFloat = simulation.scene().precision == Precision::Float;
  const double unit = isFloat ? std::numeric_limits<float>::epsilon() : std::numeric_limits<double>::epsilon();
  return kRoundings * unit * simulation.sheet().size() / simulation.dt();
}

}  // namespace

double SleepWatch::windowOf(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  const Sheet& sheet = simulation.sheet();
  const double weight = std::hypot(scene.gravity.x, scene.gravity.y, scene.gravity.z), drag = particleDamping(scene);
  double window = weight > 0 ? 2 * std::numbers::pi * std::sqrt(sheet.size() / weight) : 0;
  for (const Family family : kFamilies) {
    const double ks = familyOf(scene, family).ks;
    // The slowest swing along a row that one end holds.
    if (ks > 0) window = std::max(window, 4 * std::max(sheet.columns, sheet.rows) * std::sqrt(sheet.particleMass / ks));
  }
  if (window == 0 && drag > 0) window = sheet.particleMass / drag;
  constexpr int kTicks = 500;  // where nothing acts on the cloth at all
  return window > 0 ? window : kTicks * simulation.dt();
}

/// From a motion whose fastest speed shrinks by a factor r from window to window, at most now (r + r^2 + ...) window is
/// still to come. Speeds of rounding do not shrink; a fall that is still so slow grows by more than the share here.
bool SleepWatch::comesToRest(const Simulation& simulation, double window) const {
  if (now_ == 0) return true;
  if (!before_) return false;
  constexpr double kSteady = 1.2;
  if (now_ < speedOfRounding(simulation) && now_ < kSteady * *before_) return true;
  const double ratio = now_ / *before_;
  return ratio < 1 && now_ * window * ratio / (1 - ratio) < kUnseen * simulation.sheet().size();
}

void SleepWatch::follow(const Simulation& simulation, double kinetic) {
  constexpr double kSlow = 0.05;  // of its size in a window, on average: a faster cloth is not looked at closer
  const Sheet& sheet = simulation.sheet();
  const double time = simulation.time(), window = windowOf(simulation);
  const double average = std::sqrt(2 * kinetic / (sheet.count() * sheet.particleMass));
  if (!(average * window < kSlow * sheet.size()) || somethingIsToCome(simulation)) return wake();
  if (windowBegan_ && time < *windowBegan_) wake();
  if (!windowBegan_) windowBegan_ = time;
  now_ = std::max(now_, fastest(simulation));
  if (asleepSince_ || time - *windowBegan_ < window) return;
  if (comesToRest(simulation, window)) asleepSince_ = time;
  windowBegan_ = time;
  before_ = std::exchange(now_, 0);
}

}  // namespace tyg

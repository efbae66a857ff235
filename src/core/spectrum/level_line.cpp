// Level lines by differences of stableStep() over stiffness and damping.
#include "core/spectrum/level_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tyg {
namespace {

/// How fast the stable step shrinks with stiffness and with damping, by differences; both 0 where nothing is to learn.
struct Shrinkage {
  double byStiffness = 0, byDamping = 0;
};

Shrinkage shrinkageAt(const Method& method, const Mode& mode) {
  constexpr double kStep = 1e-4;
  const double scale = std::max(mode.w2, mode.d * mode.d), here = method.stableStep(mode.w2, mode.d);
  if (!(scale > 0) || !(here > 0) || !std::isfinite(here)) return {};
  const double stepW2 = kStep * scale, stepD = kStep * std::sqrt(scale);
  return {(here - method.stableStep(mode.w2 + stepW2, mode.d)) / stepW2,
          (here - method.stableStep(mode.w2, mode.d + stepD)) / stepD};
}

}  // namespace

LineNormal normalOfStiff(const Method& method, const Mode& mode) {
  const auto [byStiffness, byDamping] = shrinkageAt(method, mode);
  return {1, byStiffness > 0 && byDamping > 0 ? byDamping / byStiffness : 0};
}

LineNormal normalOfDamped(const Method& method, const Mode& mode) {
  const auto [byStiffness, byDamping] = shrinkageAt(method, mode);
  return {byDamping > 0 ? std::min(0.0, byStiffness / byDamping) : 0, 1};
}

bool hasStraightLevelLines(const Method& method, double d) {
  const double h = d > 0 ? method.stableStep(0, d) : std::numeric_limits<double>::infinity();
  if (!std::isfinite(h) || h <= 0) return true;
  // The undamped mode on the same line, and what lies halfway between the two.
  const double ratio = method.stableStep(1 / (h * h), 0) / h, w2 = ratio * ratio / (h * h);
  constexpr double kStraight = 0.01;
  return std::abs(method.stableStep(w2 / 2, d / 2) / h - 1) < kStraight;
}

}  // namespace tyg

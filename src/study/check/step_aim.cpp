// Two runs and two sums over the particles.
#include "study/check/step_aim.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "study/check/vectors.h"

namespace tyg {

double moderateStep(const Scene& scene) {
  double stiffness = 0, damping = 0;
  for (const SpringFamily& family : {scene.structural, scene.shear, scene.bend}) {
    stiffness += 8 * family.ks, damping += 8 * family.kd;
  }
  const double w2 = stiffness / scene.particleMass, d = (damping + scene.drag) / scene.particleMass;
  if (w2 == 0) return d == 0 ? std::numeric_limits<double>::infinity() : 2 / d;
  return (std::sqrt(d * d + 4 * w2) - d) / w2;
}

std::optional<AimTrials> aimTrials(const Model& model, const Way& way, std::span<const double> steps) {
  const double limit = moderateStep(model.scene);
  double longer = 0, shorter = 0;
  for (const double dt : steps) {
    if (!(dt > limit)) longer = std::max(longer, dt);
  }
  for (const double dt : steps) {
    if (dt <= longer / 2) shorter = std::max(shorter, dt);
  }
  if (shorter == 0) return std::nullopt;
  return AimTrials{{&model, way, longer}, {&model, way, shorter}};
}

std::optional<StepAim> aimed(const AimTrials& trials, const AimTarget& target) {
  const GivenMotion& motion = *target.motion;
  const auto end = [&](const Trial& trial) {
    return fitOf(trial, motion, {.samples = target.samples, .goesOn = target.goesOn}).last;
  };
  const std::vector<Vec3> a = end(trials.longer), b = end(trials.shorter);
  const std::vector<Vec3>& given = motion.positions[target.samples - 1];
  if (a.empty() || b.empty()) return std::nullopt;
  // With c as the difference of the two, the shorter one's distance is s c plus what no step takes away.
  double cc = 0, cb = 0, bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec3 c = a[i] - b[i], r = b[i] - given[i];
    cc += dot(c, c), cb += dot(c, r), bb += dot(r, r);
  }
  if (!(cc > 0) || !std::isfinite(cb)) return std::nullopt;
  const double s = cb / cc, longer = trials.longer.dt, shorter = trials.shorter.dt;
  const int order = trials.longer.way.order();
  const double power = std::pow(shorter, order) - s * (std::pow(longer, order) - std::pow(shorter, order));
  const double left = std::sqrt(std::max(0.0, bb - cb * cb / cc) / double(a.size()));
  return StepAim{.model = trials.longer.model,
                 .way = trials.longer.way,
                 .dt = power > 0 ? std::pow(power, 1.0 / order) : shorter,
                 .missed = left / std::max(std::sqrt(bb / double(a.size())), target.least)};
}

}  // namespace tyg

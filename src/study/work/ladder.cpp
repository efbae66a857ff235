// Steps are multiples of a method's stable limit, tolerances powers of ten.
#include "study/work/ladder.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/forces/term.h"
#include "core/scene/bodies.h"
#include "study/limits/stability.h"
#include "study/motion/sampled_motion.h"
#include "tyg/methods.h"
#include "tyg/sheet.h"

namespace tyg {
namespace {

constexpr int kFinerHalvings = 20;
/// Where nothing limits a method: of the largest step that leapfrog takes without damping, which resolves the fastest
/// wave; about two frames of a window in the built-in scenes.
constexpr double kLargestWithoutLimit = 11;
constexpr int kTolerances = 12;

/// Where no step is stable (the explicit Euler method without damping), a run of a given length still survives with
/// small ones: the search for them starts at the limit of the symplectic method.
double coarsestStep(const Scene& scene, const Method& method) {
  const double limit = restLatticeLimit(scene, method);
  if (limit > 0) return 2 * limit;
  const double other = limit == 0 ? restLatticeLimit(scene, findMethod("symplectic-euler")) : limit;
  if (other > 0) return other;
  const double fastest = restLatticeLimit(withoutDamping(scene), findMethod("leapfrog"));
  return fastest > 0 ? kLargestWithoutLimit * fastest : sampleTimes(scene).front();
}

std::vector<Rung> stepLadder(const Scene& scene, const Method& method) {
  const double interval = sampleTimes(scene).front(), coarsest = coarsestStep(scene, method);
  std::vector<Rung> rungs;
  double previous = 0;
  const auto add = [&](double step) {
    const double count = std::ceil(interval / step);
    if (count > previous) rungs.push_back({interval / count, 0});
    previous = std::max(previous, count);
  };
  add(coarsest);
  add(coarsest / std::sqrt(2.0));
  add(coarsest / 2);
  add(coarsest / std::sqrt(8.0));
  for (int k = 2; k < kFinerHalvings; ++k) add(std::ldexp(coarsest, -k));
  return rungs;
}

/// The number nearest to 10^k, the same on every machine.
double powerOfTen(int k) { return std::strtod(fmt::format("1e{}", k).c_str(), nullptr); }

std::vector<Rung> toleranceLadder(const Scene& scene) {
  const int coarsest = static_cast<int>(std::floor(std::log10(0.02 * makeSheet(scene).size())));
  std::vector<Rung> rungs;
  rungs.reserve(kTolerances);
  for (int k = 0; k < kTolerances; ++k) {
    const double tolerance = powerOfTen(coarsest - k);
    if (tolerance <= largestTolerance(scene)) rungs.push_back({scene.dt, tolerance});
  }
  return rungs;
}

}  // namespace

std::vector<Rung> ladderOf(const Scene& scene, const Method& method) {
  return method.adaptive ? toleranceLadder(scene) : stepLadder(scene, method);
}

}  // namespace tyg

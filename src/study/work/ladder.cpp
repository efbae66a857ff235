// Steps are multiples of a method's stable limit, tolerances powers of ten.
#include "study/work/ladder.h"

#include <algorithm>
#include <cmath>

#include "study/limits/stability.h"
#include "study/motion/sampled_motion.h"
#include "tyg/methods.h"
#include "tyg/sheet.h"

namespace tyg {
namespace {

constexpr int kFinerHalvings = 20;
constexpr double kLargestWithoutLimit = 1.0 / 30;  // s: two frames of a window
constexpr double kTolerances[] = {1e1, 1e0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12};

/// Where no step is stable (the explicit Euler method without damping), a run of a given length still survives with
/// small ones: the search for them starts at the limit of the symplectic method.
double coarsestStep(const Scene& scene, const Method& method) {
  const double limit = restLatticeLimit(scene, method);
  if (limit > 0) return 2 * limit;
  const double other = limit == 0 ? restLatticeLimit(scene, findMethod("symplectic-euler")) : limit;
  return other > 0 ? other : kLargestWithoutLimit;
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

std::vector<Rung> toleranceLadder(const Scene& scene) {
  const double coarsest = 0.02 * makeSheet(scene).size();
  std::vector<Rung> rungs;
  for (const double tolerance : kTolerances) {
    if (tolerance <= coarsest) rungs.push_back({scene.dt, tolerance});
  }
  return rungs;
}

}  // namespace

std::vector<Rung> ladderOf(const Scene& scene, const Method& method) {
  return method.adaptive ? toleranceLadder(scene) : stepLadder(scene, method);
}

}  // namespace tyg

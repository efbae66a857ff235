// The largest step that a method really survives, found by trying: bisection on the energy alarm.
// Must not know: predicted limits beyond where to begin, clocks, files.
#pragma once

#include <functional>
#include <optional>

#include "tyg/method.h"
#include "tyg/scene.h"

namespace tyg {

/// The scene around its rest shape: no weight, no pushes, every particle displaced at random by up to a ten-thousandth
/// of the spacing, so that springs stay as they are at rest while the displacement can grow a hundredfold before the
/// alarm goes. In double precision.
Scene linearRegime(Scene scene);

struct MeasurePlan {
  double begin = 0;          ///< s, > 0: the step to try first
  double resolution = 1e-3;  ///< the bisection ends when what failed is within this share of what held
  long long steps = 0;       ///< of each run; 0: as many as the scene's duration takes
  double mostWork = 2e8;     ///< particles times force evaluations of a run; longer ones are not made
  int threads = 1;
  std::function<bool()> observer;  ///< called often; return false to stop
};

/// Whether the scene's own motion keeps the alarm quiet to its end, with its own step or tolerance; nothing where that
/// takes more work than the plan allows, or where the observer said stop.
std::optional<bool> survives(const Scene& scene, const Method& method, const MeasurePlan& plan);

/// The largest step (s) found to hold; infinite where steps up to 8 times `begin` hold; NaN where it takes too much
/// work to tell, or where the observer said stop. Runs last a whole number of equal steps (but for the edges of
/// pushes).
double measuredLimit(const Scene& scene, const Method& method, const MeasurePlan& plan);

}  // namespace tyg

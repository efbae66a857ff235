// The largest step that a method really survives, found by trying: bisection on the energy alarm.
// Must not know: predicted limits beyond where to begin, clocks, files.
#pragma once

#include <functional>
#include <optional>

#include "tyg/method.h"
#include "tyg/scene.h"

namespace tyg {

class Simulation;

/// The scene around its rest shape: no weight, no pushes, no bodies, every particle displaced at random by up to a
/// ten-thousandth of the spacing, so that springs stay as they are at rest while the displacement can grow a
/// hundredfold before the alarm goes. In double precision.
Scene linearRegime(Scene scene);
/// A single particle that rests deep in the layer of a plane, with the contact of the scene: so deep that its stiffness
/// and damping are the largest that contact has, and with so much friction that this stays a damper of the same grip.
/// It is displaced by a ten-thousandth of the layer, and creeps slowly along the plane. In double precision.
Scene restingParticle(Scene scene);
/// Whether that particle still is where it rests, but for half of its depth.
bool isResting(const Simulation& particle);

struct MeasurePlan {
  double begin = 0;          ///< s, > 0: the step to try first
  double resolution = 1e-3;  ///< the bisection ends when what failed is within this share of what held
  long long steps = 0;       ///< of each run; 0: as many as the scene's duration takes
  double mostWork = 2e8;     ///< particles times force evaluations of a run; longer ones are not made
  int threads = 1;
  std::function<bool()> observer;  ///< called often; return false to stop
  /// Asked often: what has to hold besides the alarm's silence; empty: nothing.
  std::function<bool(const Simulation&)> holds;
};

/// Whether the scene's own motion keeps the alarm quiet to its end, with its own step or tolerance; nothing where that
/// takes more work than the plan allows, or where the observer said stop.
std::optional<bool> survives(const Scene& scene, const Method& method, const MeasurePlan& plan);

/// The largest step (s) found to hold; infinite where steps up to 8 times `begin` hold; NaN where it takes too much
/// work to tell, or where the observer said stop. Runs last a whole number of equal steps (but for the edges of
/// pushes).
double measuredLimit(const Scene& scene, const Method& method, const MeasurePlan& plan);

/// The same around rest: of the sheet in its linear regime, or of a resting particle (isResting()) where the scene has
/// contact and that is less. The searches begin where each of them is predicted to end, not at `plan.begin`.
double measuredAtRest(const Scene& scene, const Method& method, const MeasurePlan& plan);

}  // namespace tyg

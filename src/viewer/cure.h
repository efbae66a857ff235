// The ways out of a failure, a smaller step or another method at this step, and the sentences that name them.
// Must not know: windows, how a cure is taken.
#pragma once

#include <string>

#include "tyg/simulation.h"

namespace tyg {

/// The first method, in the table's order, that is predicted to stay stable with this step (s) and takes the scene;
/// null where there is none. `share`, in (0, 1]: how much of the limits at rest is left in the cloth as it is.
const Method* methodThatHolds(const Scene& scene, const Method& failed, double step, double share = 1);

/// The ways out for the present method and step.
struct Cure {
  /// s, below the present one: 0.9 of the limit, or where the step was below its limit a half of it, a quarter and so
  /// on that the scene's own motion was seen to survive; 0: no step is known to hold.
  double step = 0;
  const Method* method = nullptr;  ///< holds at the present step; null: none does
};
/// 0.9 of the limit, s; 0 where there is none.
double safeStep(double limit);
/// Where the step of a scene is at its method's limit at rest or beyond, takes a safe one, and returns a sentence that
/// says so; else changes nothing and returns none.
std::string takeStepThatHolds(Scene& scene);
/// `limit`, s: of the present method; NaN, infinite or not below the step where it does not explain a failure.
Cure findCure(const Simulation& simulation, double limit);

/// After an alarm at this time, s: which method and step broke, when, beyond what limit, and the ways out.
std::string describeFailure(const Simulation& simulation, double alarmTime, double limit, const Cure& cure);
/// After a tick that was given up when it had taken these seconds: a method that chooses its own steps may choose ever
/// smaller ones.
std::string describeStall(const Simulation& simulation, double seconds, const Cure& cure);

}  // namespace tyg

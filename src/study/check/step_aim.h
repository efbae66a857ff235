// Which step would fit best, found out from two others: how far a motion is from a method's is nearly e + c h^p, of the
// order p, and where the model is right e and c lie on one line. Must not know: which tries are worth while.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "study/check/trial.h"

namespace tyg {

/// A model and a method, and the step at which they would be nearest.
struct StepAim {
  const Model* model = nullptr;
  Way way;
  double dt = 0;      ///< s
  double missed = 0;  ///< what would be left of the distance there, as a fraction
};

/// s: symplectic Euler is stable below, and Runge-Kutta 4 exact enough to tell mistakes apart. Each of the twelve
/// springs of a particle adds at most twice its stiffness and its damping to the largest of all waves.
double moderateStep(const Scene& scene);

/// The two tries that an aim takes, the longer step first; nothing where `steps` (s) do not hold two that serve.
struct AimTrials {
  Trial longer, shorter;
};
std::optional<AimTrials> aimTrials(const Model& model, const Way& way, std::span<const double> steps);

/// What the motion is compared with to take aim.
struct AimTarget {
  const GivenMotion* motion = nullptr;
  std::size_t samples = 1;       ///< of its times, so many are run to
  double least = 0;              ///< m: a distance below this one is none
  std::function<bool()> goesOn;  ///< asked now and then; false: stop
};
std::optional<StepAim> aimed(const AimTrials& trials, const AimTarget& target);

}  // namespace tyg

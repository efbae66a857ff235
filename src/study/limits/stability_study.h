// Predicted, certified and measured step limits of a scene, method by method, with its damping and without.
// Must not know: files, terminals, clocks.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "study/limits/stability.h"

namespace tyg {

/// A method on the scene as it is, or without damping.
struct StabilityCase {
  const Method* method = nullptr;
  bool damped = false;
  StepLimit limit;
  // Measured, s: infinite where no step failed, NaN where it was not measured (no limit to begin from, too much work).
  double atRest = 0;    ///< in the linear regime, around the rest shape
  double inMotion = 0;  ///< in the scene's own motion
};

struct StabilityStudy {
  Scene scene;
  std::vector<StabilityCase> cases;   ///< method by method, with damping first
  std::vector<std::string> refusals;  ///< of methods that do not take the scene
  bool stopped = false;
};

struct StabilityPlan {
  std::vector<const Method*> methods;
  int threads = 1;
  std::function<bool(double)> observer;      ///< told the share of the work done; return false to stop
  static constexpr long long kSteps = 2000;  ///< of a run in the linear regime
};

StabilityStudy studyStability(const Scene& scene, const StabilityPlan& plan);

/// stability.csv: header `scene,integrator,damping,predicted_dt,certified_dt,measured_dt,first_mode`. `scene` is the
/// scene's name for its own motion, and `NAME at rest` for the linear regime; damping is `scene` or `none`; numbers
/// that do not exist are empty, limits that were not reached `inf`.
std::string stabilityCsv(const StabilityStudy& study);
/// The same for people, in at most 100 columns, with what has to be said about methods without a limit.
std::string stabilityTable(const StabilityStudy& study);

}  // namespace tyg

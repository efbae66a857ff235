// A run as a study sees it: where every particle was at a few times that all runs of a scene share.
// Must not know: references, methods by name, clocks.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "tyg/simulation.h"

namespace tyg {

/// At least 20 equally spaced times after t = 0 up to the scene's duration, s. More of them, up to 64, where that lets
/// every edge of a push fall on one: equal steps between sample times then are equal steps between all stop times.
std::vector<double> sampleTimes(const Scene& scene);

/// Positions of all particles at sample times. A run that failed or was stopped holds only the samples before that.
struct SampledMotion {
  std::vector<double> times;                 ///< s
  std::vector<std::vector<Vec3>> positions;  ///< m; by time, then particle
  std::vector<Missing> missing;              ///< what cuts and tears have taken by then
  std::vector<double> energies;              ///< kinetic, elastic and gravitational at those times, J
  Status status = Status::Ok;
  bool stopped = false;    ///< by the observer, or by SamplingOptions::mostEvaluations
  std::int64_t steps = 0;  ///< accepted ones
  std::int64_t forceEvaluations = 0;
  double largestStep = 0;  ///< s
  double energyDrift =
      0;          ///< largest size of the ledger's drift at a sample time, fraction of its scale; NaN without ledger
  Ledger ledger;  ///< where the run ended; dissipated and drift only with SamplingOptions::ledger
};

/// What a run needs besides its scene and method.
struct SamplingOptions {
  int threads = 0;      ///< as Settings::threads
  bool ledger = false;  ///< follow the energy's drift too
  /// A run that has made so many ends within 64 steps, `stopped`; 0: any number.
  std::int64_t mostEvaluations = 0;
  /// Gets the simulated time (s) now and then; false stops the run. May be empty.
  std::function<bool(double time)> observer;
  std::shared_ptr<Device> device{};  ///< as Settings::device
};

/// Runs the scene and samples it at `times` (ascending, s). Throws InputError as Simulation does.
SampledMotion sampledRun(const Scene& scene, const Method& method, const std::vector<double>& times,
                         const SamplingOptions& options = {});

}  // namespace tyg

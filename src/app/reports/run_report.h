// What `tyg run` says about a run: a summary for people, a JSON object for scripts, and advice after a failure.
// Must not know: options, how the run was driven.
#pragma once

#include <limits>
#include <string>

#include "app/reports/device_report.h"
#include "tyg/simulation.h"

namespace tyg {

/// A run that has ended, well or not.
struct FinishedRun {
  const Simulation& simulation;
  Ledger ledger;             ///< at the end
  bool followsLoss = false;  ///< was Settings::ledger on? dissipated and drift mean nothing otherwise
  double seconds = 0;        ///< of the clock, in stepping alone
  double stableStep = 0;     ///< rest-lattice limit, s; NaN where there is none
  /// K + E + G - W at the start, J; NaN where it is not known.
  double startEnergy = std::numeric_limits<double>::quiet_NaN();
  bool replayed = false;  ///< did a log's events act on it, which no other run can try?
  DeviceReport device{};  ///< what moved the cloth
};

/// One JSON object; its keys and their order are what scripts rely on.
std::string runJson(const FinishedRun& run);
/// A few lines with units.
std::string runSummary(const FinishedRun& run);
/// Before the run: what is simulated, by which method, on how many threads, and the spans between stop times.
std::string runPlan(const Simulation& simulation);
/// After an alarm: method, step, time, predicted limit and what to try. What it advises was run on the scene to its end
/// and held, within some seconds; what takes longer, or follows a replay, it calls predicted.
std::string failureAdvice(const FinishedRun& run);

}  // namespace tyg

// The rows of a speed-against-accuracy study, and their CSV form.
// Must not know: how rows come about, how they are drawn.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "tyg/scene.h"

namespace tyg {

/// How a run of a study ended. TooSlow: it was stopped when it had taken longer than a study allows one run.
enum class RowStatus { Ok, Unstable, NotFinite, TooSlow };
/// `ok`, `unstable`, `not-finite`, `too-slow`.
std::string_view nameOf(RowStatus status);

/// What took the steps that a row's seconds are of.
enum class RowDevice { Cpu, Gpu };
/// `cpu`, `gpu`.
std::string_view nameOf(RowDevice device);

/// One method at one step or tolerance on one scene. Numbers that a failed run does not have are NaN.
struct WorkRow {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  std::string scene;
  int columns = 0, rows = 0;
  std::string integrator;
  Precision precision = Precision::Double;
  double dt = kNone;       ///< largest step taken, s
  double tolerance = 0;    ///< m; 0 where steps are fixed
  std::int64_t steps = 0;  ///< accepted ones
  std::int64_t forceEvaluations = 0;
  double seconds = kNone;      ///< of stepping alone, the least of some repeats; of a failed run until it failed
  double rmsError = kNone;     ///< E, m
  double maxError = kNone;     ///< of any particle at any sample time, m
  double energyDrift = kNone;  ///< largest at a sample time, fraction of the energy scale
  double floor = kNone;        ///< least error that means something in this precision, m
  double horizon = kNone;      ///< last time at which this row's error means something, s
  RowStatus status = RowStatus::Ok;
  RowDevice device = RowDevice::Cpu;

  /// Does the row's error mean something over the whole run of `duration` seconds?
  [[nodiscard]] bool trusted(double duration) const { return status == RowStatus::Ok && horizon >= duration; }
};

/// The rows with the header scene,columns,rows,integrator,precision,dt,tolerance,steps,force_evaluations,seconds,
/// rms_error_m,max_error_m,energy_drift,floor_m,horizon_s,status,device.
std::string workCsv(const std::vector<WorkRow>& rows);

/// Reads what workCsv() wrote, the device left out or not. Throws InputError with file, line, what was found and what
/// is allowed.
std::vector<WorkRow> parseWorkCsv(std::string_view text, const std::string& fileName);

}  // namespace tyg

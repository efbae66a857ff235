// Which method reaches an error most cheaply, read off the rows of a study.
// Must not know: how rows come about, charts.
#pragma once

#include <string>
#include <vector>

#include "study/work/work_rows.h"

namespace tyg {

enum class Cost { Seconds, Evaluations };

/// What a method needs to come within an error.
struct Price {
  std::string integrator;
  Precision precision = Precision::Double;
  double cost = 0;       ///< s of the clock, or force evaluations, for the whole run
  double dt = 0;         ///< s, largest step of the row
  double tolerance = 0;  ///< m, of the row; 0 for methods with steps of dt
};

/// The cheapest row of each method and precision whose error, E and floor together, is at most `error` (m), cheapest
/// first. Rows as they are: nothing is interpolated, so every price was really paid.
std::vector<Price> pricesOf(const std::vector<WorkRow>& rows, double error, Cost cost);

}  // namespace tyg

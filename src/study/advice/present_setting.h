// What error and cost to expect of the setting that a person has chosen, read from the rows of a study, and which of
// the rows are better. Must not know: how rows come about, how anything is drawn.
#pragma once

#include <vector>

#include "study/work/work_rows.h"
#include "tyg/method.h"

namespace tyg {

/// A method with the step or the tolerance that it is used with.
struct Setting {
  const Method* method = nullptr;
  double dt = 0;                  ///< s, used by methods of fixed steps
  double tolerance = 0;           ///< m, used by adaptive ones
  double limit = WorkRow::kNone;  ///< s, the largest stable dt where one is known; NaN: none is
};

/// The error and the cost to expect of a setting, read from its method's rows.
struct SettingEstimate {
  enum class Kind {
    Unknown,   ///< no row of that method has an error yet
    Measured,  ///< it is one of the rows
    Between,   ///< it is between two rows: interpolated on logarithmic scales
    Finer,     ///< it is finer than all rows: extrapolated by the method's order, down to the floor
    Coarser,   ///< it is coarser than all rows that held, and none failed there: extrapolated likewise
    Fails,     ///< rows with such a step failed, or the step is past its limit
  };
  Kind kind = Kind::Unknown;
  double error = WorkRow::kNone;    ///< E, m; NaN where it is unknown or fails
  double seconds = WorkRow::kNone;  ///< of the whole run; NaN likewise
};
SettingEstimate estimateOf(const std::vector<WorkRow>& rows, const Setting& setting);

/// The rows that no other row beats in both error and cost, the cheapest first. They point into `rows`.
std::vector<const WorkRow*> frontierOf(const std::vector<WorkRow>& rows);

/// Rows that are better than a setting by enough to be worth a change; null where there is none.
struct BetterRows {
  const WorkRow* cheaper = nullptr;  ///< of those with no greater error that cost at least a tenth less, the cheapest
  const WorkRow* closer =
      nullptr;  ///< of those that cost no more and have at most half the error, the one of least error
};
BetterRows betterThan(const std::vector<WorkRow>& rows, const SettingEstimate& estimate);

}  // namespace tyg

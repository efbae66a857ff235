// Where the setting that a person has chosen stands among the rows of a study, and which of the rows would serve
// better. Must not know: how rows come about, how anything is drawn.
#pragma once

#include <string_view>
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

/// The error and the cost of a setting, read between its method's rows.
struct SettingPlace {
  enum class Kind {
    Unknown,   ///< no row of that method has an error yet
    Measured,  ///< it is a row
    Between,   ///< two rows
    Finer,     ///< than all rows: followed at the method's order, down to the floor
    Coarser,   ///< than all rows that held, and none failed there: followed likewise
    Fails,     ///< rows with such a step failed, or the step is past its limit
  };
  Kind kind = Kind::Unknown;
  double error = WorkRow::kNone;    ///< E, m; NaN where it is unknown or fails
  double seconds = WorkRow::kNone;  ///< of the whole run; NaN likewise
};
SettingPlace placeOf(const std::vector<WorkRow>& rows, const Setting& setting);

/// The rows that no other row beats in both error and cost, the cheapest first. They point into `rows`.
std::vector<const WorkRow*> frontierOf(const std::vector<WorkRow>& rows);

/// Rows that would serve better than a place by enough to be worth a change; null where there is none.
struct BetterRows {
  const WorkRow* cheaper = nullptr;  ///< no greater error, at least a tenth cheaper: the cheapest
  const WorkRow* closer = nullptr;   ///< no dearer, at most half the error: the least error
};
BetterRows betterThan(const std::vector<WorkRow>& rows, const SettingPlace& place);

}  // namespace tyg

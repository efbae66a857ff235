// The model diet: what each part of a scene costs, and what is lost without it; then the most reduced scene that stays
// within a tolerance. Must not know: files, words of reports, clocks (costs are given).
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "study/diet/diet_changes.h"
#include "study/motion/error.h"
#include "study/motion/reference.h"
#include "study/work/cost.h"
#include "study/work/work_rows.h"

namespace tyg {

/// A scene on the diet, run to its end. Numbers that a failed run does not have are NaN.
struct DietRow {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  std::string words = "as written";  ///< the change
  Scene scene;
  RowStatus status = RowStatus::Ok;
  Distance lost{kNone, kNone};  ///< from the full model's reference up to Diet::judgedUpTo, m; `rms` is E
  double worstAt = 0;           ///< s: when it is that far away
  double floor = kNone;         ///< least E that means something there in this precision, m
  double horizon = kNone;       ///< last time at which this E means something, s
  double maxStretch = kNone;    ///< fraction of the rest length
  double sag = kNone;           ///< from the highest to the lowest particle at the end, m
  double energy = kNone;        ///< kinetic, elastic and gravitational at the end, J
  std::int64_t work = 0;        ///< units: force evaluations, or steps for a method without any
  double seconds = kNone;       ///< work times its calibrated cost
  double counted = kNone;       ///< the same in counted springs (countedCost), which choices follow
  double saved = 0;             ///< fraction of the seconds of the scene as written
  bool within = false;          ///< is E within the tolerance?

  /// Is E more than what rounding alone may make of it?
  [[nodiscard]] bool meant(double judgedUpTo) const { return horizon >= judgedUpTo; }
};

struct Diet {
  double within = 0;           ///< the tolerance, m
  double judgedUpTo = 0;       ///< s: the last time at which such an error means something; E is taken up to here
  DietRow written;             ///< the scene as it is
  std::vector<DietRow> alone;  ///< one change at a time
  std::vector<DietRow>
      together;  ///< the changes that were kept, each on top of those before; the last row has them all
  bool stopped = false;

  /// The scene with all changes that were kept.
  [[nodiscard]] const DietRow& reduced() const { return together.empty() ? written : together.back(); }
};

struct DietPlan {
  double within = 0;  ///< m
  int threads = 1;
  UnitCost cost;
  /// Gets the fraction done now and then and may return false: the diet then ends with the rows so far.
  std::function<bool(double fraction)> observer;
};

/// Puts a scene on the diet. `reference` is of that scene and usable. Changes that keep E within the tolerance and save
/// more than a tenth of the counted cost, or cost the same and lose nothing more, are kept together greedily: the
/// largest saving first, halved sheets, longer steps and cheaper methods again and again.
Diet dietOf(const Scene& scene, const Reference& reference, const DietPlan& plan);

}  // namespace tyg

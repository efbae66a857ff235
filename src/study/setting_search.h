// Finds the cheapest setting of method, step and precision within an error, or the most exact one within a cost, by
// running few of them. Must not know: where the true motion comes from, clocks (costs are given), words of reports.
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "study/cost.h"

namespace tyg {

/// A setting and what a run at it gave.
struct Trial {
  Scene scene;  ///< with the setting's method, step or tolerance, and precision
  Status status = Status::Ok;
  double error = std::numeric_limits<double>::infinity();  ///< E, m; infinite for a run that failed
  std::int64_t work = 0;                                   ///< units
  double seconds = 0;                                      ///< work times its calibrated cost
};

struct SearchPlan {
  std::vector<const Method*> methods;
  std::vector<Precision> precisions{Precision::Double, Precision::Float};
  int threads = 1;
  UnitCost cost;
  double mostSeconds = 3;  ///< no run that is expected to cost more is tried; at least four of the cheapest run's cost
  double allSeconds = 15;  ///< of all runs of one search; at least six of the dearest run's
  /// Called now and then; false stops.
  std::function<bool()> observer;
};

/// Runs are kept: a second search on the same motion starts from what the first one learnt.
class SettingSearch {
 public:
  /// `truth` is what errors are measured against; both must outlive this object. Methods that refuse the scene, and
  /// those that no study may recommend, are left out.
  SettingSearch(const Scene& scene, const SampledMotion& truth, SearchPlan plan);
  ~SettingSearch();
  SettingSearch(const SettingSearch&) = delete;
  SettingSearch& operator=(const SettingSearch&) = delete;

  /// The cheapest setting found whose E is at most `error` m; of those that cost up to a tenth more, the most exact
  /// one. Nothing where there is none that mostSeconds can pay.
  std::optional<Trial> cheapestWithin(double error);
  /// The setting of least E found whose cost is at most `seconds`. Nothing where every stable run costs more.
  std::optional<Trial> mostExactWithin(double seconds);

  /// Of all runs so far, the one of least error and the cheapest that did not fail.
  [[nodiscard]] std::optional<Trial> leastError() const;
  [[nodiscard]] std::optional<Trial> cheapest() const;
  [[nodiscard]] int runs() const { return static_cast<int>(trials_.size()); }
  [[nodiscard]] bool stopped() const { return stopped_; }

 private:
  struct Candidate;
  [[nodiscard]] std::vector<Candidate> candidates() const;
  [[nodiscard]] double mostSecondsFor(const std::vector<Candidate>& all) const;
  /// One run of a candidate at a knob: a step (s) or a tolerance (m).
  const Trial& tryOut(const Candidate& candidate, double knob);

  const Scene& scene_;
  const SampledMotion& truth_;
  SearchPlan plan_;
  std::map<std::string, Trial> trials_;
  bool stopped_ = false;
};

}  // namespace tyg

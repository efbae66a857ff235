// Finds the cheapest setting of method, step and precision within an error, or the most exact one within a cost, by
// running few of them. Must not know: where the true motion comes from, clocks (costs are given), words of reports.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "study/advice/setting_candidate.h"

namespace tyg {

struct SearchPlan {
  std::vector<const Method*> methods;
  std::vector<Precision> precisions{Precision::Double, Precision::Float};
  int threads = 1;
  UnitCost cost;
  DeviceOffer device{};  ///< takes the runs that cost less there
  /// No run that costs more is made: at least real time, and four times what the cheapest run costs.
  double mostSeconds = 1.5;
  double allSeconds = 4;  ///< of all runs of one search: at least three times what the most expensive run may cost
  /// Gets the number of runs made now and then; false stops.
  std::function<bool(int runs)> observer;
};

/// Runs are kept: a second search starts from what the first one learnt.
class SettingSearch {
 public:
  /// `scene` must outlive this object. Methods that refuse the scene, and those that no study may recommend, are left
  /// out.
  SettingSearch(const Scene& scene, SearchPlan plan);

  /// What errors are measured against from now on; it must outlive this object or be replaced. Errors that were
  /// measured before and are below `unsure` m are forgotten.
  void measureAgainst(const SampledMotion& truth, double unsure);

  /// The cheapest setting found whose E is at most `error` m; of those that cost up to a tenth more, the most exact
  /// one. Nothing where there is none that mostSeconds and `seconds` can pay.
  std::optional<Trial> cheapestWithin(double error, double seconds = std::numeric_limits<double>::infinity());
  /// The setting of least E found whose cost is at most `seconds`; where several come below `floor` m, the cheapest of
  /// them. Nothing where every stable run costs more.
  std::optional<Trial> mostExactWithin(double seconds, double floor);

  /// Of all runs so far, the one of least error and the cheapest that did not fail.
  [[nodiscard]] std::optional<Trial> leastError() const;
  [[nodiscard]] std::optional<Trial> cheapest() const;
  [[nodiscard]] int runs() const { return runs_; }
  [[nodiscard]] double spent() const { return spent_; }  ///< s of all runs so far
  /// s: the most that one run may cost.
  [[nodiscard]] double mostSeconds() const { return mostSeconds_; }
  /// Did the last search end because all of its seconds were spent?
  [[nodiscard]] bool gaveUp() const { return gaveUp_; }
  [[nodiscard]] bool stopped() const { return stopped_; }

 private:
  void gatherCandidates();
  [[nodiscard]] double leastSeconds(double error) const;
  [[nodiscard]] std::optional<Trial> bestWithin(double error, double seconds) const;
  [[nodiscard]] std::optional<Trial> bestFor(double seconds) const;
  [[nodiscard]] double allSeconds() const;
  [[nodiscard]] double endOf(std::size_t candidate, const std::vector<SettingCandidate::Next>& next) const;
  [[nodiscard]] Price priceOf(const Scene& scene) const {
    return cheapestPrice(plan_.cost, plan_.device, scene, plan_.threads);
  }
  /// One run at a parameter, which is cut short where it would cost more than `most` s.
  void tryOut(SettingCandidate& candidate, double parameter, double most);

  const Scene& scene_;
  const SampledMotion* truth_ = nullptr;
  SearchPlan plan_;
  std::vector<SettingCandidate> candidates_;
  double mostSeconds_ = 0;
  int runs_ = 0;
  double spent_ = 0;
  bool gaveUp_ = false, stopped_ = false;
};

}  // namespace tyg

// One method in one precision: its parameter, which is a step or a tolerance, what its runs have shown so far, and
// which run is worth making next. Must not know: other candidates, how runs are made, clocks.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "study/work/cost.h"

namespace tyg {

/// A setting and what a run at it gave.
struct Trial {
  Scene scene;  ///< with the setting's method, step or tolerance, and precision
  Status status = Status::Ok;
  double error = std::numeric_limits<double>::infinity();  ///< E, m; infinite for a run that failed or was cut short
  std::int64_t work = 0;                                   ///< units
  double seconds = 0;                                      ///< work times its calibrated cost
  bool cutShort = false;                                   ///< it cost more than it was allowed to
  double wholeSeconds = 0;                                 ///< what it would have cost then, about; else the same
  std::shared_ptr<Device> device{};                        ///< that it ran on; null: the processor
  double elsewhere = std::numeric_limits<double>::infinity();  ///< s that it would take on the other, see Price
};

class SettingCandidate {
 public:
  /// `interval` (s) is the time between samples: fixed steps divide it, so that sampling changes none of them.
  SettingCandidate(const Scene& scene, const Method& method, Precision precision, double interval);

  struct Run {
    double parameter;  ///< step in s, or tolerance in m
    Trial trial;
  };

  [[nodiscard]] const Method& method() const { return *method_; }
  [[nodiscard]] Scene at(double parameter) const;
  [[nodiscard]] double loosest() const { return loosest_; }
  [[nodiscard]] const std::vector<Run>& runs() const { return runs_; }  ///< the loosest parameter first
  [[nodiscard]] const Run* known(double parameter) const;               ///< null where it was not run

  /// What a step costs (s), before any run tells. Adaptive methods tell by their runs alone.
  void priceStep(double seconds) { perStep_ = seconds; }
  /// Takes a run into account, in place of an earlier one at the same parameter.
  void learn(double parameter, const Trial& trial);
  /// Forgets the runs whose error is below `error` m, but not what a step costs.
  void forgetBelow(double error);

  /// s that a run costs, about; 0 where nothing is known.
  [[nodiscard]] double expectedAt(double parameter) const;
  /// The tightest parameter that `seconds` can pay for, but never looser than the loosest.
  [[nodiscard]] double payable(double seconds) const;
  /// E (m) of a run, extrapolated from the tightest known; 0 where nothing is known, infinite where rounding, not the
  /// method, is what is left.
  [[nodiscard]] double errorAt(double parameter) const;

  /// The run to make next in order to find the loosest parameter whose error is within `error` (m).
  struct Next {
    double parameter = 0;                                      ///< 0: none, another run would tell nothing new
    double seconds = std::numeric_limits<double>::infinity();  ///< that it will cost, about
    /// s that a run within the error will cost in the end, extrapolated from what is known; 0 where nothing is.
    double inTheEnd = 0;
  };
  [[nodiscard]] Next next(double error) const;

 private:
  [[nodiscard]] double divided(double parameter) const;
  [[nodiscard]] double leastError() const;
  [[nodiscard]] double sameParameter() const;
  struct TwoRuns {
    const Run *last = nullptr, *before = nullptr;
  };
  [[nodiscard]] TwoRuns tightestRuns() const;
  [[nodiscard]] double costExponent(const TwoRuns& runs) const;
  [[nodiscard]] bool gainsNothing() const;
  [[nodiscard]] double guess(const Run* good, const Run* bad, double error) const;
  [[nodiscard]] double factor(const Trial& trial, double error) const;
  /// How E follows the parameter: E ~ parameter^exponent.
  [[nodiscard]] double exponent() const;

  const Method* method_;
  Scene scene_;
  double interval_;
  double loosest_ = 0, tightest_ = 0;  // parameters
  double perStep_ = 0;                 // s; unused by adaptive methods
  std::vector<Run> runs_;
};

}  // namespace tyg

// Advice with proof: the cheapest method, step, precision and threads for an error or a time budget, found by a quick
// study and proven by one more run against the reference. Must not know: files, words of reports, which clock it is.
#pragma once

#include "study/advice/setting_search.h"
#include "study/motion/reference.h"

namespace tyg {

/// What is asked for: one of the two.
struct Request {
  double error = 0;   ///< m: E over the whole run is to be at most this
  double budget = 0;  ///< s of computing for a sixtieth of a simulated second
};

/// A sixtieth of a second: what a frame of a window shows.
inline constexpr double kFrame = 1.0 / 60;
/// s of computing for a frame, of a run of `duration` s that takes `seconds`.
inline double frameSeconds(double seconds, double duration) { return seconds / duration * kFrame; }

struct Advice {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  Request request;
  int threads = 1;
  bool met = false;              ///< does the promise meet the request? Otherwise it is the nearest that was found
  std::optional<Trial> promise;  ///< by the quick study; none where every run failed
  double knowable = 0;           ///< m: the quick study cannot tell errors below this, and does not search for them
  double achieved = kNone;       ///< E against the reference, m
  double uncertainty = kNone;    ///< the distance between the reference and its second opinion, m
  double floor = kNone;          ///< least E that means something, m
  double measured = kNone;       ///< s that the run took by the clock, least of up to three
  bool held = false;             ///< did the proof keep the promise?
  bool secondTry = false;        ///< the first choice did not hold: this one was found against the reference itself
  double missed = 0;             ///< E of that first choice, m
  double limit = 0;  ///< largest stable step at rest of the chosen method, s; NaN: none, 0: no step is stable
  std::optional<Trial> tenTimesBetter;  ///< the cheapest found within a tenth of the error
  /// s: where none was found, no run that costs more was made; 0: no run was made, because a tenth of the error is less
  /// than can be known.
  double tenTimesUpTo = 0;
  bool tenTimesGaveUp = false;  ///< there may be one: the search took too long
  int runs = 0;                 ///< of the quick study
  bool stopped = false;
  bool proven = false;  ///< was there a usable reference?

  /// Is the choice as exact as the reference itself is known to be?
  [[nodiscard]] bool beyondReference() const { return 3 * uncertainty > achieved; }
};

struct AdvicePlan {
  Request request;
  std::vector<const Method*> methods;
  std::vector<Precision> precisions{Precision::Double, Precision::Float};
  std::vector<int> threads{1};  ///< to choose from
  UnitCost cost;
  DeviceOffer device{};                      ///< beside the processor
  double mostSeconds = 1.5, allSeconds = 4;  ///< as of SearchPlan
  CostMeter::Clock clock;                    ///< s, for `measured` alone
  /// Gets the fraction done now and then; false stops.
  std::function<bool(double fraction)> observer;
};

/// The quick study alone: threads, promise, and what ten times better would cost.
Advice quickAdvice(const Scene& scene, const AdvicePlan& plan);

/// The quick study, the reference, and the proof. Where the promise of an error does not hold, the study is done once
/// more against the reference and proven again.
Advice adviseOn(const Scene& scene, const AdvicePlan& plan);

}  // namespace tyg

// Speed against accuracy: each method down a ladder of steps or tolerances, errors first, then seconds.
// Must not know: files, charts, what time it is (the clock is given).
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "study/motion/reference.h"
#include "study/work/past_horizon.h"
#include "study/work/work_rows.h"

namespace tyg {

/// How a study is done.
struct StudyPlan {
  std::vector<const Method*> methods;
  std::vector<Precision> precisions{Precision::Double, Precision::Float};
  double runBudget = 1;  ///< s that one run may take; a ladder ends with the first run that takes longer. Runs may
                         ///< take kUntilTwoHold times as long while fewer than two of the ladder's have held: a
                         ///< method that holds with tiny steps alone is then seen to.
  static constexpr double kUntilTwoHold = 4;
  double lowestError = 0;  ///< m; a ladder ends below it, and below the floor of double
  /// So many rungs of every ladder come before the rest of any, for those who watch the rows come; 0: one ladder after
  /// the other.
  std::size_t firstRungs = 0;
  int fewestRepeats = 3;       ///< of each timing
  double repeatSeconds = 0.2;  ///< short runs are timed more often, until this much has gone into them
  double roundsBudget = 50;    ///< s for all repeats together: no further run begins after it
  int threads = 0;             ///< as Settings::threads
  /// Takes the timed runs of the methods that it knows, in float; null: none. Its bits must be the processor's, which
  /// takes the runs for the errors.
  std::shared_ptr<Device> device{};
  std::function<double()> clock;  ///< s, from any start
  /// Gets the fraction done now and then and may return false: the study then ends with the rows so far.
  std::function<bool(double fraction)> observer;
  /// Gets every row when its error and its first timing are known, for those who do not want to wait. May be empty.
  std::function<void(const WorkRow& row)> rowObserver;
};

struct Study {
  std::vector<WorkRow> rows;             ///< method by method, double before float, coarse to fine
  std::vector<PastHorizon> pastHorizon;  ///< of the rows whose error does not mean something over the whole run
  std::vector<std::string> refusals;     ///< why a method is not in the rows: what it says about the scene
  int tornElsewhere = 0;                 ///< rows in whose runs other springs broke than in the reference
  bool stopped = false;
};

/// The rows of a scene. A run's error is measured at the reference's sample times, with the ledger on; its seconds and
/// its work are those of another run that is neither sampled nor followed by a ledger, timed after the error run and
/// again, the methods taking turns, when all errors are known. `reference` must be usable.
Study workPrecision(const Scene& scene, const Reference& reference, const StudyPlan& plan);

}  // namespace tyg

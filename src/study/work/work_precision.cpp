// First every method goes down its ladder, with a run for the error and a first timed run on every rung; then all timed
// runs are repeated in rounds.
#include "study/work/work_precision.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "study/motion/error.h"
#include "study/motion/progress.h"
#include "study/motion/tearing.h"
#include "study/work/ladder.h"

namespace tyg {
namespace {

constexpr double kLadderShare = 0.55;  // of the whole work, about as measured
constexpr int kMostRepeats = 12;

RowStatus rowStatus(Status status) {
  return status == Status::Ok ? RowStatus::Ok : status == Status::Unstable ? RowStatus::Unstable : RowStatus::NotFinite;
}

/// What all runs of a study share.
struct Shared {
  const Scene& scene;
  const Reference& reference;
  const StudyPlan& plan;
  std::vector<double> times;  // s, of the samples
  Progress progress;
};

/// A row, and what is needed to time it again.
struct TimedRow {
  WorkRow row;
  Scene scene;
  const Method* method;
  std::optional<PastHorizon> past;
  bool tornElsewhere = false;
  std::size_t rung = 0;  // its index in the ladder
  int repeats = 0;
  double spent = 0;  // s, in timing
};

/// One method in one precision, as far down its ladder as it is.
struct Series {
  const Method* method;
  Precision precision;
  std::vector<Rung> rungs;
  std::vector<TimedRow> runs;  // of the first rungs
  bool ended = false;
  std::string refusal;  // what the method says about the scene; empty where it takes it
};

std::vector<Series> seriesOf(const Scene& scene, const StudyPlan& plan) {
  std::vector<Series> all;
  for (const Method* method : plan.methods) {
    for (const Precision precision : plan.precisions) {
      all.push_back({.method = method,
                     .precision = precision,
                     .rungs = ladderOf(scene, *method),
                     .runs = {},
                     .ended = false,
                     .refusal = {}});
    }
  }
  return all;
}

/// s that the next run of a series may take.
double budgetOf(const Series& series, const StudyPlan& plan) {
  const auto held = std::ranges::count(series.runs, RowStatus::Ok, [](const TimedRow& run) { return run.row.status; });
  return (held < 2 ? StudyPlan::kUntilTwoHold : 1) * plan.runBudget;
}

/// Runs a scene for its error within a budget of s; `goesOn` is asked now and then, and what it stops is not finished.
TimedRow errorRun(const Scene& scene, const Method& method, double budget, const Shared& shared,
                  const std::function<bool()>& goesOn) {
  const StudyPlan& plan = shared.plan;
  const Reference& reference = shared.reference;
  const double start = plan.clock();
  const auto observer = [&](double) {
    const bool late = plan.clock() - start > budget;
    return goesOn() && !late;
  };
  const SampledMotion motion =
      sampledRun(scene, method, shared.times, {.threads = plan.threads, .ledger = true, .observer = observer});
  TimedRow run{.row = {}, .scene = scene, .method = &method, .past = {}};
  WorkRow& row = run.row;
  row.scene = scene.name, row.columns = scene.columns, row.rows = scene.rows;
  row.integrator = method.name, row.precision = scene.precision;
  row.dt = motion.largestStep, row.tolerance = method.adaptive ? scene.tolerance : 0;
  row.steps = motion.steps, row.forceEvaluations = motion.forceEvaluations;
  row.floor = reference.floorOf(scene.precision);
  row.status = motion.stopped ? RowStatus::TooSlow : rowStatus(motion.status);
  if (row.status == RowStatus::TooSlow) row.seconds = plan.clock() - start;
  if (row.status != RowStatus::Ok) return run;
  const Distance error = motionError(motion, reference.motion);
  run.tornElsewhere = firstTornElsewhere(motion, reference.motion).has_value();
  row.rmsError = error.rms, row.maxError = error.largest;
  row.energyDrift = motion.energyDrift;
  row.horizon = reference.horizonOf(error.rms, scene.precision);
  if (!row.trusted(scene.duration)) {
    run.past = {.row = {},
                .distance = reference.distanceAfter(row.horizon, motion),
                .band = reference.bandAfter(row.horizon, scene.precision)};
  }
  return run;
}

/// Whether the plan's device takes the run.
bool isForDevice(const TimedRow& run, const StudyPlan& plan) {
  if (!plan.device || run.scene.precision != Precision::Float) return false;
  try {
    const Simulation simulation(run.scene, *run.method, {.threads = 1, .device = plan.device});
    return true;
  } catch (const InputError&) {
    return false;
  }
}

/// Times the run of a row: the same scene from stop to stop, with nothing else between the steps.
void time(TimedRow& run, Shared& shared) {
  const bool onDevice = run.row.device == RowDevice::Gpu;
  Simulation simulation(run.scene, *run.method,
                        {.threads = shared.plan.threads, .device = onDevice ? shared.plan.device : nullptr});
  simulation.observe([&] { return shared.progress.goesOn(); });
  const double start = shared.plan.clock();
  simulation.advanceTo(run.scene.duration);
  const double seconds = shared.plan.clock() - start;
  if (shared.progress.stopped()) return;
  WorkRow& row = run.row;
  if (row.status == RowStatus::Ok) row.status = rowStatus(simulation.status());
  row.steps = simulation.steps(), row.forceEvaluations = simulation.forceEvaluations();
  row.dt = simulation.largestStep();
  row.seconds = run.repeats == 0 ? seconds : std::min(row.seconds, seconds);
  run.spent += seconds;
  ++run.repeats;
}

/// Is the error as small as it can or shall be, or did the run take too long?
bool endsLadder(const std::vector<TimedRow>& runs, const Shared& shared) {
  const WorkRow& row = runs.back().row;
  if (row.status == RowStatus::TooSlow) return true;
  if (row.status != RowStatus::Ok) return false;
  // Not even double tells such errors. Float goes on past its own floor, which is the worst that rounding may do:
  // what it does is seen where its curve ends.
  if (row.rmsError < std::max(shared.reference.floorOf(Precision::Double), shared.plan.lowestError)) return true;
  // Rounding, not the method, is what is left where two finer rungs gain nothing near the floor.
  constexpr double kNearTheFloor = 1000, kNoGain = 0.7;
  if (runs.size() < 3 || !(row.rmsError < kNearTheFloor * row.floor)) return false;
  const double before = runs[runs.size() - 3].row.rmsError, between = runs[runs.size() - 2].row.rmsError;
  return between > kNoGain * before && row.rmsError > kNoGain * before;
}

/// One rung of a series down.
void climb(Series& series, Shared& shared, const std::function<bool()>& goesOn) {
  const Rung& rung = series.rungs[series.runs.size()];
  Scene scene = shared.scene;
  scene.precision = series.precision;
  scene.dt = rung.dt;
  scene.tolerance = rung.tolerance;
  try {
    TimedRow run = errorRun(scene, *series.method, budgetOf(series, shared.plan), shared, goesOn);
    if (shared.progress.stopped()) return;
    run.rung = series.runs.size();
    if (isForDevice(run, shared.plan)) run.row.device = RowDevice::Gpu;
    series.runs.push_back(std::move(run));
  } catch (const InputError& refusal) {
    series.refusal = refusal.what();
    series.ended = true;
    return;
  }
  TimedRow& run = series.runs.back();
  if (run.row.status != RowStatus::TooSlow) time(run, shared);
  if (shared.progress.stopped()) return;
  if (shared.plan.rowObserver) shared.plan.rowObserver(run.row);
  series.ended = endsLadder(series.runs, shared);
}

/// Every series down to so many rungs. The climbs are `share` of the whole work, of which `done` came before.
void climbAll(std::vector<Series>& all, std::size_t rungs, Shared& shared, double done, double share) {
  const double each = share / double(all.size());
  for (Series& series : all) {
    const double start = shared.plan.clock();
    const auto goesOn = [&] {
      // A climb takes some budgets' time at most; one that ends early makes the rest come sooner.
      constexpr double kBudgetsPerClimb = 5;
      const double inClimb = (shared.plan.clock() - start) / (kBudgetsPerClimb * shared.plan.runBudget);
      return shared.progress.reach(done + each * std::min(1.0, inClimb));
    };
    const std::size_t last = std::min(rungs, series.rungs.size());
    while (!shared.progress.stopped() && !series.ended && series.runs.size() < last) climb(series, shared, goesOn);
    done += each;
  }
}

bool wantsRepeat(const TimedRow& run, const StudyPlan& plan) {
  if (run.row.status != RowStatus::Ok || run.repeats >= kMostRepeats) return false;
  return run.repeats < plan.fewestRepeats || run.spent < plan.repeatSeconds;
}

/// s that all repeats together will take, about.
double expectedRepeats(const std::vector<TimedRow*>& runs, const StudyPlan& plan) {
  double expected = 0;
  for (const TimedRow* run : runs) {
    if (!wantsRepeat(*run, plan)) continue;
    expected += std::max((plan.fewestRepeats - 1) * run->row.seconds,
                         std::min(plan.repeatSeconds, (kMostRepeats - 1) * run->row.seconds));
  }
  return std::min(expected, plan.roundsBudget);
}

/// Rounds over all rows, neighbours in time being different methods at the same rung of their ladders: whatever slows
/// the machine down for a while slows all methods down.
void repeatTimings(std::vector<Series>& all, Shared& shared) {
  const StudyPlan& plan = shared.plan;
  std::vector<TimedRow*> order;
  for (Series& series : all) {
    for (TimedRow& run : series.runs) order.push_back(&run);
  }
  std::ranges::stable_sort(order, {}, &TimedRow::rung);
  const double expected = expectedRepeats(order, plan), start = plan.clock();
  double spent = 0;
  for (bool any = true; any && !shared.progress.stopped();) {
    any = false;
    for (TimedRow* run : order) {
      const bool wanted = !shared.progress.stopped() && wantsRepeat(*run, plan);
      if (!wanted || plan.clock() - start > plan.roundsBudget) continue;
      any = true;
      const double before = run->spent;
      time(*run, shared);
      spent += run->spent - before;
      shared.progress.advanceTo(kLadderShare + (1 - kLadderShare) * std::min(1.0, spent / expected));
    }
  }
}

Study studyOf(const std::vector<Series>& all, bool stopped) {
  Study study;
  study.stopped = stopped;
  for (const Series& series : all) {
    for (const TimedRow& run : series.runs) {
      study.rows.push_back(run.row);
      if (run.tornElsewhere) ++study.tornElsewhere;
      if (run.past) study.pastHorizon.push_back({run.row, run.past->distance, run.past->band});
    }
    const std::string& refusal = series.refusal;  // begins with the name of the method
    if (refusal.empty() || std::ranges::find(study.refusals, refusal) != study.refusals.end()) continue;
    study.refusals.push_back(refusal);
  }
  return study;
}

}  // namespace

Study workPrecision(const Scene& scene, const Reference& reference, const StudyPlan& plan) {
  Shared shared{.scene = scene,
                .reference = reference,
                .plan = plan,
                .times = sampleTimes(scene),
                .progress = Progress(plan.observer)};
  std::vector<Series> all = seriesOf(scene, plan);
  const double firstShare = plan.firstRungs > 0 ? kLadderShare / 2 : 0;
  if (plan.firstRungs > 0) climbAll(all, plan.firstRungs, shared, 0, firstShare);
  climbAll(all, std::numeric_limits<std::size_t>::max(), shared, firstShare, kLadderShare - firstShare);
  if (!shared.progress.stopped()) repeatTimings(all, shared);
  return studyOf(all, shared.progress.stopped());
}

}  // namespace tyg

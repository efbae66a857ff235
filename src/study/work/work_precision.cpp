// The study: ladders of error runs, then rounds of timing.
#include "study/work/work_precision.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "study/motion/error.h"
#include "study/work/ladder.h"

namespace tyg {
namespace {

constexpr double kLadderShare = 0.55;  // of the whole work, about as measured
constexpr int kMostRepeats = 12;

RowStatus rowStatus(Status status) {
  return status == Status::Ok ? RowStatus::Ok : status == Status::Unstable ? RowStatus::Unstable : RowStatus::NotFinite;
}

class StudyMaker {
 public:
  StudyMaker(const Scene& scene, const Reference& reference, const StudyPlan& plan)
      : scene_(scene), reference_(reference), plan_(plan), times_(sampleTimes(scene)) {}

  Study make() {
    for (const Method* method : plan_.methods) {
      for (const Precision precision : plan_.precisions) {
        series_.push_back({.method = method, .precision = precision, .rungs = ladderOf(scene_, *method), .runs = {}});
      }
    }
    if (plan_.firstRungs > 0) climbAll(plan_.firstRungs);
    climbAll(std::numeric_limits<std::size_t>::max());
    if (!study_.stopped) repeatTimings();
    for (const Series& series : series_) {
      for (const Timed& run : series.runs) {
        study_.rows.push_back(run.row);
        if (run.past) study_.pastHorizon.push_back({run.row, run.past->distance, run.past->band});
      }
    }
    return std::move(study_);
  }

 private:
  /// A row, and what is needed to time it again.
  struct Timed {
    WorkRow row;
    Scene scene;
    const Method* method;
    std::optional<PastHorizon> past;
    std::size_t rung = 0;  ///< its place in the ladder
    int repeats = 0;
    double spent = 0;  ///< s, in timing
  };

  /// One method in one precision, as far down its ladder as it is.
  struct Series {
    const Method* method;
    Precision precision;
    std::vector<Rung> rungs;
    std::vector<Timed> runs;  ///< of the first rungs
    bool ended = false;
  };

  /// Every series down to so many rungs.
  void climbAll(std::size_t rungs) {
    for (Series& series : series_) {
      climbStart_ = plan_.clock();
      while (!study_.stopped && !series.ended && series.runs.size() < std::min(rungs, series.rungs.size()))
        climb(series);
      ++climbs_;
    }
  }

  /// One rung; the last where the error is as small as it can or shall be, or the run takes too long.
  void climb(Series& series) {
    Scene scene = scene_;
    scene.precision = series.precision;
    const Rung& rung = series.rungs[series.runs.size()];
    scene.dt = rung.dt;
    scene.tolerance = rung.tolerance;
    try {
      Timed run = errorRun(scene, *series.method);
      if (study_.stopped) return;
      run.rung = series.runs.size();
      series.runs.push_back(std::move(run));
    } catch (const InputError& refusal) {
      refuse(*series.method, refusal.what());
      series.ended = true;
      return;
    }
    Timed& run = series.runs.back();
    if (run.row.status != RowStatus::TooSlow) time(run);
    if (study_.stopped) return;
    if (plan_.rowObserver) plan_.rowObserver(run.row);
    series.ended = endsLadder(series.runs);
  }

  void refuse(const Method& method, const std::string& why) {
    const std::string text = std::string(method.name) + ": " + why;
    if (std::ranges::find(study_.refusals, text) == study_.refusals.end()) study_.refusals.push_back(text);
  }

  Timed errorRun(const Scene& scene, const Method& method) {
    const double start = plan_.clock();
    bool late = false;
    const auto observer = [&](double) {
      late = plan_.clock() - start > plan_.runBudget;
      return goesOn(ladderFraction()) && !late;
    };
    const SampledMotion motion =
        sampledRun(scene, method, times_, {.threads = plan_.threads, .ledger = true, .observer = observer});
    Timed run{.row = {}, .scene = scene, .method = &method, .past = {}};
    WorkRow& row = run.row;
    row.scene = scene.name, row.columns = scene.columns, row.rows = scene.rows;
    row.integrator = method.name, row.precision = scene.precision;
    row.dt = motion.largestStep, row.tolerance = method.adaptive ? scene.tolerance : 0;
    row.steps = motion.steps, row.forceEvaluations = motion.forceEvaluations;
    row.floor = reference_.floorOf(scene.precision);
    row.status = motion.stopped ? RowStatus::TooSlow : rowStatus(motion.status);
    if (row.status == RowStatus::TooSlow) row.seconds = plan_.clock() - start;
    if (row.status != RowStatus::Ok) return run;
    const Distance error = motionError(motion, reference_.motion);
    row.rmsError = error.rms, row.maxError = error.largest;
    row.energyDrift = motion.energyDrift;
    row.horizon = reference_.horizonOf(error.rms, scene.precision);
    if (!row.trusted(scene.duration)) {
      run.past = {.row = {},
                  .distance = reference_.distanceAfter(row.horizon, motion),
                  .band = reference_.bandAfter(row.horizon, scene.precision)};
    }
    return run;
  }

  /// Times the run of a row: the same scene from stop to stop, with nothing else between the steps.
  void time(Timed& run) {
    Simulation simulation(run.scene, *run.method, {.threads = plan_.threads});
    simulation.observe([&] { return goesOn(fraction_); });
    const double start = plan_.clock();
    simulation.advanceTo(run.scene.duration);
    const double seconds = plan_.clock() - start;
    if (study_.stopped) return;
    WorkRow& row = run.row;
    if (row.status == RowStatus::Ok) row.status = rowStatus(simulation.status());
    row.steps = simulation.steps(), row.forceEvaluations = simulation.forceEvaluations();
    row.dt = simulation.largestStep();
    row.seconds = run.repeats == 0 ? seconds : std::min(row.seconds, seconds);
    run.spent += seconds;
    ++run.repeats;
  }

  [[nodiscard]] bool endsLadder(const std::vector<Timed>& runs) const {
    const WorkRow& row = runs.back().row;
    if (row.status == RowStatus::TooSlow) return true;
    if (row.status != RowStatus::Ok) return false;
    // Not even double tells such errors. Float goes on past its own floor, which is the worst that rounding may do:
    // what it does is seen where its curve ends.
    if (row.rmsError < std::max(reference_.floorOf(Precision::Double), plan_.lowestError)) return true;
    // Rounding, not the method, is what is left where two finer rungs gain nothing near the floor.
    constexpr double kNearTheFloor = 1000, kNoGain = 0.7;
    if (runs.size() < 3 || !(row.rmsError < kNearTheFloor * row.floor)) return false;
    const double before = runs[runs.size() - 3].row.rmsError, between = runs[runs.size() - 2].row.rmsError;
    return between > kNoGain * before && row.rmsError > kNoGain * before;
  }

  [[nodiscard]] bool wantsRepeat(const Timed& run) const {
    if (run.row.status != RowStatus::Ok || run.repeats >= kMostRepeats) return false;
    return run.repeats < plan_.fewestRepeats || run.spent < plan_.repeatSeconds;
  }

  /// Rounds over all rows, neighbours in time being different methods at the same place of their ladders: whatever
  /// slows the machine down for a while slows all methods down.
  void repeatTimings() {
    std::vector<Timed*> order;
    for (Series& series : series_) {
      for (Timed& run : series.runs) order.push_back(&run);
    }
    std::ranges::stable_sort(order, {}, &Timed::rung);
    double expected = 0, spent = 0;
    for (const Timed* run : order) {
      if (!wantsRepeat(*run)) continue;
      expected += std::max((plan_.fewestRepeats - 1) * run->row.seconds,
                           std::min(plan_.repeatSeconds, (kMostRepeats - 1) * run->row.seconds));
    }
    expected = std::min(expected, plan_.roundsBudget);
    const double start = plan_.clock();
    for (bool any = true; any && !study_.stopped;) {
      any = false;
      for (Timed* run : order) {
        if (study_.stopped || !wantsRepeat(*run) || plan_.clock() - start > plan_.roundsBudget) continue;
        any = true;
        const double before = run->spent;
        time(*run);
        spent += run->spent - before;
        fraction_ = kLadderShare + (1 - kLadderShare) * std::min(1.0, spent / expected);
      }
    }
  }

  /// A climb takes some budgets' time at most; one that ends early makes the rest come sooner.
  double ladderFraction() {
    constexpr double kBudgetsPerClimb = 5;
    const double inClimb = std::min(1.0, (plan_.clock() - climbStart_) / (kBudgetsPerClimb * plan_.runBudget));
    const auto all = double(series_.size() * (plan_.firstRungs > 0 ? 2 : 1));
    return fraction_ = std::max(fraction_, kLadderShare * (double(climbs_) + inClimb) / all);
  }

  bool goesOn(double fraction) {
    if (plan_.observer && !plan_.observer(fraction)) study_.stopped = true;
    return !study_.stopped;
  }

  const Scene& scene_;
  const Reference& reference_;
  const StudyPlan& plan_;
  std::vector<double> times_;
  Study study_;
  std::vector<Series> series_;
  std::size_t climbs_ = 0;  ///< of one series each, done
  double climbStart_ = 0, fraction_ = 0;
};

}  // namespace

Study workPrecision(const Scene& scene, const Reference& reference, const StudyPlan& plan) {
  return StudyMaker(scene, reference, plan).make();
}

}  // namespace tyg

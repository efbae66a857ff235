// A quick study promises: its truth is two cheap runs, its choice the best that a search finds. Then comes the proof:
// the promised setting once more, against a reference.
#include "study/advice/advice.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "core/scene/bodies.h"
#include "study/limits/stability.h"
#include "study/motion/error.h"
#include "study/motion/progress.h"
#include "tyg/methods.h"
#include "tyg/sheet.h"

namespace tyg {
namespace {

// Shares of the whole work.
constexpr double kStudyShare = 0.4, kReferenceShare = 0.5, kProofShare = 0.05;
/// The quick study knows the true motion and the machine's speed only so well: its choice keeps to these fractions of
/// what was asked.
constexpr double kErrorMargin = 0.9, kBudgetMargin = 0.95;
/// An error below so many times the uncertainty of the truth cannot be told from no error.
constexpr double kCertain = 3;
constexpr double kTenTimesBetter = 0.1;   // the fraction of the error that "ten times better" means
constexpr double kTightestTruth = 1e-13;  // tolerance, of the size: the reference's own
constexpr double kRoughTruth = 1e-8;      // the same: cheap, and enough where little can be spent

/// A motion to measure errors against, and how far it may be off.
struct Truth {
  SampledMotion motion;
  double tolerance = 0;    // m, that it was run with
  double uncertainty = 0;  // m, the largest RMS over particles

  [[nodiscard]] double floor() const { return kCertain * uncertainty; }
};

/// What all parts of the work need.
struct Task {
  const Scene& scene;
  const AdvicePlan& plan;
  double size;  // m, of the sheet
  int threads;
  Progress progress;

  [[nodiscard]] bool asksForError() const { return plan.request.error > 0; }
};

/// The cheapest number by the scene's own setting, a gain below a tenth not counting.
int cheapestThreads(const Scene& scene, const AdvicePlan& plan) {
  constexpr double kWorthwhile = 0.9;
  int cheapest = 1;
  double least = std::numeric_limits<double>::infinity();
  for (const int threads : plan.threads) {
    const double cost = plan.threads.size() == 1 ? 0 : plan.cost(scene, threads);
    if (cost < kWorthwhile * least) least = cost, cheapest = threads;
  }
  return cheapest;
}

Task taskOf(const Scene& scene, const AdvicePlan& plan) {
  refuseEndlessReference(scene);
  return {.scene = scene,
          .plan = plan,
          .size = makeSheet(scene).size(),
          .threads = cheapestThreads(scene, plan),
          .progress = Progress(plan.observer)};
}

/// Two runs of an adaptive method, far cheaper than a reference. Its error goes with its tolerance, so that the
/// looser run's distance is some nine times the tighter one's error; until rounding is what is left.
Truth truthWithin(double ofSize, Task& task) {
  constexpr double kLooser = 10, kOfTheDistance = 1.0 / 5;
  Truth truth;
  Scene scene = task.scene;
  scene.precision = Precision::Double;
  const double wanted = std::max(ofSize, kTightestTruth) * task.size;
  scene.tolerance = truth.tolerance = std::min(wanted, largestTolerance(scene) / kLooser);
  // Where forces are extreme its steps may be so short that it would not end, whatever the springs alone allow.
  constexpr double kMostWork = 1e10, kFewest = 1e6, kMost = 3e7;  // evaluations times particles, and evaluations
  const double ofParticles = kMostWork / (double(scene.columns) * scene.rows);
  const auto mostEvaluations = std::int64_t(std::clamp(ofParticles, kFewest, kMost));
  const auto run = [&] {
    const auto observer = [&](double) { return task.progress.goesOn(); };
    SampledMotion motion =
        sampledRun(scene, findMethod("dopri54"), sampleTimes(scene),
                   {.threads = task.threads, .mostEvaluations = mostEvaluations, .observer = observer});
    if (motion.stopped && !task.progress.stopped()) {
      throw InputError(
          fmt::format("{}: found a motion for which dopri54 needs more than {} force evaluations at a tolerance of "
                      "{:.2g} m; allowed "
                      "are gentler forces, or a shorter --duration",
                      scene.name, mostEvaluations, scene.tolerance));
    }
    return motion;
  };
  truth.motion = run();
  scene.tolerance *= kLooser;
  const double apart = motionError(run(), truth.motion).rms;
  truth.uncertainty = std::isfinite(apart) ? kOfTheDistance * apart : task.size;
  return truth;
}

bool isTightest(double tolerance, const Task& task) { return tolerance <= kTightestTruth * task.size * (1 + 1e-9); }

/// A truth that tells errors ten times below the one that is asked for.
Truth truthForError(Task& task) {
  constexpr double kOfTheError = 1e-4, kTighter = 1e-3;
  const double wanted = kErrorMargin * kTenTimesBetter * task.plan.request.error;
  double ofSize = std::min(kOfTheError * task.plan.request.error / task.size, kRoughTruth);
  Truth truth = truthWithin(ofSize, task);
  while (!task.progress.stopped() && truth.floor() > wanted && !isTightest(truth.tolerance, task)) {
    truth = truthWithin(ofSize *= kTighter, task);
  }
  return truth;
}

SearchPlan searchPlanFor(Task& task) {
  SearchPlan plan;
  plan.methods = task.plan.methods;
  plan.precisions = task.plan.precisions;
  plan.threads = task.threads;
  plan.cost = task.plan.cost;
  plan.device = task.plan.device;
  plan.mostSeconds = task.plan.mostSeconds;
  plan.allSeconds = task.plan.allSeconds;
  plan.observer = [&task](int runs) { return task.progress.reach(kStudyShare * (1 - 1 / (1 + 0.05 * runs))); };
  return plan;
}

Advice withPromise(Advice advice, SettingSearch& search, double floor, const Task& task) {
  const Request& request = task.plan.request;
  if (task.asksForError()) {
    advice.promise = search.cheapestWithin(std::max(kErrorMargin * request.error, floor));
    advice.met = advice.promise && floor <= request.error;
    if (!advice.promise) advice.promise = search.leastError();
  } else {
    const double whole = request.budget * task.scene.duration / kFrame;
    advice.promise = search.mostExactWithin(kBudgetMargin * whole, floor);
    advice.met = advice.promise.has_value();
    if (!advice.met) advice.promise = search.cheapestWithin(task.size);
    if (!advice.promise) advice.promise = search.cheapest();
  }
  return advice;
}

/// Settings up to so many times the cost of the choice: what costs more is of no use to the person who asked.
Advice withTenTimesBetter(Advice advice, SettingSearch& search, double floor, const Task& task) {
  constexpr double kDearest = 100;
  const double asked = task.asksForError() ? task.plan.request.error : advice.promise->error;
  const double within = kErrorMargin * kTenTimesBetter * asked;
  advice.tenTimesBetter.reset();
  advice.tenTimesUpTo = 0;
  if (within < floor) return advice;
  advice.tenTimesUpTo = std::min(kDearest * advice.promise->seconds, search.mostSeconds());
  advice.tenTimesBetter = search.cheapestWithin(within, advice.tenTimesUpTo);
  advice.tenTimesGaveUp = search.gaveUp();
  return advice;
}

/// The best choice that the search finds, by errors that are measured against this truth.
Advice chosenBy(const Truth& truth, SettingSearch& search, Advice advice, const Task& task) {
  constexpr double kSure = 10;  // errors so many times above what could not be told before are still right
  search.measureAgainst(truth.motion, kSure * advice.knowable);
  const double floor = advice.knowable = truth.floor();
  advice = withPromise(std::move(advice), search, floor, task);
  if (advice.met && !search.stopped()) {
    advice = withTenTimesBetter(std::move(advice), search, floor, task);
    // What was learnt by that may show a better choice.
    const Scene first = advice.promise->scene;
    advice = withPromise(std::move(advice), search, floor, task);
    if (!(advice.promise->scene == first) && !task.asksForError()) {
      advice = withTenTimesBetter(std::move(advice), search, floor, task);
    }
  }
  advice.runs = search.runs();
  if (advice.promise) advice.limit = restLatticeLimit(task.scene, findMethod(advice.promise->scene.integrator));
  return advice;
}

/// Advice that is not proven yet, and what a second try goes on from.
struct QuickStudy {
  Advice advice;
  Truth truth;
  std::optional<SettingSearch> search;  // none where the study was stopped before it
};

QuickStudy quickStudy(Task& task) {
  QuickStudy study;
  study.advice.request = task.plan.request;
  study.advice.threads = task.threads;
  double ofSize = kRoughTruth;
  study.truth = task.asksForError() ? truthForError(task) : truthWithin(ofSize, task);
  if (task.progress.stopped()) return study;
  study.search.emplace(task.scene, searchPlanFor(task));
  study.advice = chosenBy(study.truth, *study.search, std::move(study.advice), task);
  if (task.asksForError()) return study;
  // What a budget buys is not known beforehand: where the truth is too rough to tell, the search goes on with one that
  // is not.
  while (!task.progress.stopped() && study.advice.met && !isTightest(study.truth.tolerance, task)) {
    constexpr double kSurely = 0.1, kMostTighter = 1e-3;
    const double wanted = kErrorMargin * kTenTimesBetter * study.advice.promise->error;
    if (study.truth.floor() <= wanted) break;
    ofSize *= std::clamp(kSurely * wanted / study.truth.floor(), kMostTighter, kSurely);
    study.truth = truthWithin(ofSize, task);
    if (task.progress.stopped()) break;
    study.advice = chosenBy(study.truth, *study.search, std::move(study.advice), task);
  }
  return study;
}

/// As exact as it takes to tell an error of `promised` m; where it does not turn out so, as exact as can be.
Reference referenceFor(double promised, const Truth& truth, Task& task) {
  constexpr int kLarge = 2000;  // particles: a run of them is too long to wait for many
  constexpr double kOfThePromise = 1.0 / 10, kOfTheUncertainty = 1.0 / 3, kEnough = 1.0 / kCertain;
  const auto observer = [&](double fraction) { return task.progress.reach(kStudyShare + kReferenceShare * fraction); };
  ReferenceAim aim;
  aim.agreement = std::max(kOfThePromise * promised, kOfTheUncertainty * truth.uncertainty);
  aim.tolerance = truth.tolerance * std::min(1.0, kOfThePromise * promised / truth.uncertainty);
  aim.motion = &truth.motion;
  aim.patience = task.scene.columns * task.scene.rows > kLarge ? 2 : ReferenceAim{}.patience;
  Reference reference = makeReference(task.scene, task.threads, observer, aim);
  const bool exact = reference.usable() && reference.disagreement.back() <= kEnough * promised;
  if (exact || isTightest(reference.scene.tolerance, task) || task.progress.stopped()) return reference;
  return makeReference(task.scene, task.threads, observer,
                       {.tolerance = 0, .agreement = 0, .motion = nullptr, .patience = aim.patience});
}

/// s that a run takes by the clock, the least of up to three.
double measuredSeconds(const Trial& choice, double expected, Task& task) {
  constexpr int kRepeats = 3;
  constexpr double kLongEnough = 1;  // s: of long runs one will do
  double least = Advice::kNone;
  for (int k = 0; k < kRepeats && !task.progress.stopped() && !(k * expected > kLongEnough); ++k) {
    Simulation simulation(choice.scene, findMethod(choice.scene.integrator),
                          {.threads = task.threads, .device = choice.device});
    simulation.observe([&] { return task.progress.goesOn(); });
    const int busy = choice.device ? std::max(2, task.threads) : task.threads;
    const double start = task.plan.clock(busy);
    simulation.advanceTo(choice.scene.duration);
    least = std::fmin(least, task.plan.clock(busy) - start);
  }
  return least;
}

/// Runs the promised setting, and measures it against the reference.
Advice proven(Advice advice, const Reference& reference, Task& task) {
  const Trial& promise = *advice.promise;
  const Method& method = findMethod(promise.scene.integrator);
  const double duration = task.scene.duration;
  const auto observer = [&](double time) {
    return task.progress.reach(kStudyShare + kReferenceShare + kProofShare * time / duration);
  };
  const SampledMotion run = sampledRun(promise.scene, method, reference.motion.times,
                                       {.threads = task.threads, .observer = observer, .device = promise.device});
  advice.achieved = motionError(run, reference.motion).rms;
  advice.uncertainty = reference.disagreement.back();
  advice.floor = reference.floorOf(promise.scene.precision);
  const Price price = cheapestPrice(task.plan.cost, task.plan.device, promise.scene, task.threads);
  const double cost = static_cast<double>(workOf(method, run)) * price.seconds;
  constexpr double kNear = 1.1;  // of what was found nearest to a request that cannot be met
  if (task.asksForError()) {
    const double asked = advice.met ? task.plan.request.error : kNear * promise.error;
    advice.held = advice.achieved + advice.uncertainty <= asked;
  } else {
    const double asked = advice.met ? task.plan.request.budget : kNear * frameSeconds(promise.seconds, duration);
    advice.held = frameSeconds(cost, duration) <= asked;
  }
  advice.measured = measuredSeconds(promise, cost, task);
  return advice;
}

Advice fullAdvice(Task& task) {
  QuickStudy study = quickStudy(task);
  Advice advice = std::move(study.advice);
  if (task.progress.stopped() || !advice.promise) return advice;
  const Reference reference = referenceFor(advice.promise->error, study.truth, task);
  advice.proven = reference.usable() && !task.progress.stopped();
  if (!advice.proven) return advice;
  advice = proven(std::move(advice), reference, task);
  if (!task.asksForError() || !advice.met || advice.held || task.progress.stopped()) return advice;
  advice.secondTry = true;
  advice.missed = advice.achieved;
  advice.knowable = std::numeric_limits<double>::infinity();  // the truth so far was none
  study.truth.motion = reference.motion;
  study.truth.uncertainty = advice.uncertainty;
  advice = chosenBy(study.truth, *study.search, std::move(advice), task);
  if (!advice.promise || task.progress.stopped()) return advice;
  return proven(std::move(advice), reference, task);
}

}  // namespace

Advice quickAdvice(const Scene& scene, const AdvicePlan& plan) {
  Task task = taskOf(scene, plan);
  Advice advice = quickStudy(task).advice;
  advice.stopped = task.progress.stopped();
  return advice;
}

Advice adviseOn(const Scene& scene, const AdvicePlan& plan) {
  Task task = taskOf(scene, plan);
  Advice advice = fullAdvice(task);
  advice.stopped = task.progress.stopped();
  return advice;
}

}  // namespace tyg

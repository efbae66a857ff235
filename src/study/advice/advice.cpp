// The quick study, the proof, and what is said around them.
#include "study/advice/advice.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "study/limits/stability.h"
#include "study/motion/error.h"
#include "tyg/methods.h"
#include "tyg/sheet.h"

namespace tyg {
namespace {

// Shares of the whole work.
constexpr double kStudyShare = 0.4, kReferenceShare = 0.5, kProofShare = 0.05;
/// The quick study knows the truth and the machine only so well.
constexpr double kErrorMargin = 0.9, kBudgetMargin = 0.95;
/// An error below so many times the truth's own uncertainty is not told from none.
constexpr double kTold = 3;
constexpr double kBetter = 0.1;           // as exact as what is said of "ten times better"
constexpr double kTightestTruth = 1e-13;  // tolerance, of the size: the reference's own
constexpr double kRoughTruth = 1e-8;      // the same: cheap, and enough where little can be spent

/// A motion to measure errors against, and how far it may be off.
struct Truth {
  SampledMotion motion;
  double tolerance = 0;    // m, that it was run with
  double uncertainty = 0;  // m, the largest RMS over particles

  [[nodiscard]] double floor() const { return kTold * uncertainty; }
};

class Adviser {
 public:
  Adviser(const Scene& scene, const AdvicePlan& plan) : scene_(scene), plan_(plan), size_(makeSheet(scene).size()) {
    advice_.request = plan.request;
  }

  Advice quick() {
    chooseThreads();
    (plan_.request.error > 0 ? studyError() : studyBudget());
    return advice_;
  }

  Advice proven() {
    quick();
    if (advice_.stopped || !advice_.promise) return advice_;
    const Reference reference = makeReferenceFor(advice_.promise->error);
    if (advice_.stopped) return advice_;
    advice_.proven = reference.usable();
    if (!advice_.proven) return advice_;
    prove(reference);
    if (plan_.request.error > 0 && advice_.met && !advice_.held && !advice_.stopped) {
      advice_.secondTry = true;
      advice_.missed = advice_.achieved;
      truth_.motion = reference.motion;
      truth_.uncertainty = advice_.uncertainty;
      advice_.knowable = std::numeric_limits<double>::infinity();  // the truth so far was none
      study();
      if (advice_.promise && !advice_.stopped) prove(reference);
    }
    return advice_;
  }

 private:
  bool goesOn(double fraction) {
    fraction_ = std::max(fraction_, fraction);
    if (plan_.observer && !plan_.observer(fraction_)) advice_.stopped = true;
    return !advice_.stopped;
  }

  /// The cheapest by the scene's own setting, a gain below a tenth not counting.
  void chooseThreads() {
    constexpr double kWorthwhile = 0.9;
    double least = std::numeric_limits<double>::infinity();
    for (const int threads : plan_.threads) {
      const double cost = plan_.threads.size() == 1 ? 0 : plan_.cost(scene_, threads);
      if (cost < kWorthwhile * least) least = cost, advice_.threads = threads;
    }
  }

  /// Two runs of an adaptive method, far cheaper than a reference. Its error goes with its tolerance, so that the
  /// looser run's distance is some nine times the tighter one's error; until rounding is what is left.
  void findTruth(double ofSize) {
    constexpr double kLooser = 10, kOfTheDistance = 1.0 / 5;
    Scene scene = scene_;
    scene.precision = Precision::Double;
    scene.tolerance = truth_.tolerance = std::max(ofSize, kTightestTruth) * size_;
    const auto run = [&] {
      const auto observer = [&](double time) { return goesOn(fraction_ + 1e-9 * time); };
      return sampledRun(scene, findMethod("dopri54"), sampleTimes(scene_),
                        {.threads = advice_.threads, .observer = observer});
    };
    truth_.motion = run();
    scene.tolerance *= kLooser;
    const double apart = motionError(run(), truth_.motion).rms;
    truth_.uncertainty = std::isfinite(apart) ? kOfTheDistance * apart : size_;
  }

  [[nodiscard]] bool tightestTruth() const { return truth_.tolerance <= kTightestTruth * size_ * (1 + 1e-9); }

  /// The truth must tell errors ten times below the one that is asked for.
  void studyError() {
    constexpr double kOfTheError = 1e-4, kTighter = 1e-3;
    const double wanted = kErrorMargin * kBetter * plan_.request.error;
    for (double ofSize = std::min(kOfTheError * plan_.request.error / size_, kRoughTruth);; ofSize *= kTighter) {
      findTruth(ofSize);
      if (advice_.stopped) return;
      if (truth_.floor() <= wanted || tightestTruth()) break;
    }
    study();
  }

  /// What a budget buys is not known beforehand: where the truth is too rough to tell, the search goes on with one that
  /// is not.
  void studyBudget() {
    constexpr double kSurely = 0.1, kMostTighter = 1e-3;
    for (double ofSize = kRoughTruth;;) {
      findTruth(ofSize);
      if (advice_.stopped) return;
      study();
      if (advice_.stopped || !advice_.met || tightestTruth()) return;
      const double wanted = kErrorMargin * kBetter * advice_.promise->error;
      if (truth_.floor() <= wanted) return;
      ofSize *= std::clamp(kSurely * wanted / truth_.floor(), kMostTighter, kSurely);
    }
  }

  void study() {
    constexpr double kSure = 10;  // errors so many times above what could not be told before are still right
    if (!search_) startSearch();
    search_->measureAgainst(truth_.motion, kSure * advice_.knowable);
    advice_.knowable = truth_.floor();
    choose();
    if (advice_.met && !search_->stopped()) {
      findTenTimesBetter();
      // What was learnt by that may show a better choice.
      const Scene first = advice_.promise->scene;
      choose();
      if (!(advice_.promise->scene == first) && plan_.request.budget > 0) findTenTimesBetter();
    }
    advice_.runs = search_->runs();
    if (advice_.promise) advice_.limit = restLatticeLimit(scene_, findMethod(advice_.promise->scene.integrator));
  }

  void startSearch() {
    SearchPlan plan;
    plan.methods = plan_.methods;
    plan.precisions = plan_.precisions;
    plan.threads = advice_.threads;
    plan.cost = plan_.cost;
    plan.mostSeconds = plan_.mostSeconds;
    plan.allSeconds = plan_.allSeconds;
    plan.observer = [this] {
      const int runs = search_ ? search_->runs() : 0;
      return goesOn(kStudyShare * (1 - 1 / (1 + 0.05 * runs)));
    };
    search_.emplace(scene_, std::move(plan));
  }

  void choose() {
    if (plan_.request.error > 0) {
      const double within = std::max(kErrorMargin * plan_.request.error, truth_.floor());
      advice_.promise = search_->cheapestWithin(within);
      advice_.met = advice_.promise && truth_.floor() <= plan_.request.error;
      if (!advice_.promise) advice_.promise = search_->leastError();
    } else {
      const double whole = plan_.request.budget * scene_.duration / kFrame;
      advice_.promise = search_->mostExactWithin(kBudgetMargin * whole, truth_.floor());
      advice_.met = advice_.promise.has_value();
      if (!advice_.met) advice_.promise = search_->cheapestWithin(size_);
      if (!advice_.promise) advice_.promise = search_->cheapest();
    }
  }

  /// Up to so many times the cost of the choice: dearer ones are of no use to whoever asked.
  void findTenTimesBetter() {
    constexpr double kDearest = 100;
    const double asked = plan_.request.error > 0 ? plan_.request.error : advice_.promise->error;
    const double within = kErrorMargin * kBetter * asked;
    advice_.tenTimesBetter.reset();
    advice_.tenTimesUpTo = 0;
    if (within < truth_.floor()) return;
    advice_.tenTimesUpTo = std::min(kDearest * advice_.promise->seconds, search_->mostSeconds());
    advice_.tenTimesBetter = search_->cheapestWithin(within, advice_.tenTimesUpTo);
    advice_.tenTimesGaveUp = search_->gaveUp();
  }

  /// As exact as it takes to tell an error of `promised` m; where it does not turn out so, as exact as can be.
  Reference makeReferenceFor(double promised) {
    constexpr int kLarge = 2000;  // particles: a run of them is too long to wait for many
    constexpr double kOfThePromise = 1.0 / 10, kOfTheUncertainty = 1.0 / 3, kEnough = 1.0 / kTold;
    const auto observer = [&](double fraction) { return goesOn(kStudyShare + kReferenceShare * fraction); };
    ReferenceAim aim;
    aim.agreement = std::max(kOfThePromise * promised, kOfTheUncertainty * truth_.uncertainty);
    aim.tolerance = truth_.tolerance * std::min(1.0, kOfThePromise * promised / truth_.uncertainty);
    aim.motion = &truth_.motion;
    aim.patience = scene_.columns * scene_.rows > kLarge ? 2 : ReferenceAim{}.patience;
    Reference reference = makeReference(scene_, advice_.threads, observer, aim);
    const bool exact = reference.usable() && reference.disagreement.back() <= kEnough * promised;
    const bool rougher = reference.scene.tolerance > kTightestTruth * size_ * (1 + 1e-9);
    if (exact || !rougher || advice_.stopped) return reference;
    return makeReference(scene_, advice_.threads, observer,
                         {.tolerance = 0, .agreement = 0, .motion = nullptr, .patience = aim.patience});
  }

  void prove(const Reference& reference) {
    const Trial& promise = *advice_.promise;
    const Method& method = findMethod(promise.scene.integrator);
    const auto observer = [&](double time) {
      return goesOn(kStudyShare + kReferenceShare + kProofShare * time / scene_.duration);
    };
    const SampledMotion run =
        sampledRun(promise.scene, method, reference.motion.times, {.threads = advice_.threads, .observer = observer});
    advice_.achieved = motionError(run, reference.motion).rms;
    advice_.uncertainty = reference.disagreement.back();
    advice_.floor = reference.floorOf(promise.scene.precision);
    const double cost = static_cast<double>(workOf(method, run)) * plan_.cost(promise.scene, advice_.threads);
    constexpr double kNear = 1.1;  // of what was found nearest to a request that cannot be met
    if (plan_.request.error > 0) {
      const double asked = advice_.met ? plan_.request.error : kNear * promise.error;
      advice_.held = advice_.achieved + advice_.uncertainty <= asked;
    } else {
      const double asked = advice_.met ? plan_.request.budget : kNear * frameSeconds(promise.seconds, scene_.duration);
      advice_.held = frameSeconds(cost, scene_.duration) <= asked;
    }
    constexpr int kRepeats = 3;
    constexpr double kLongEnough = 1;  // s: of long runs one will do
    advice_.measured = Advice::kNone;
    for (int k = 0; k < kRepeats && !advice_.stopped && !(k * cost > kLongEnough); ++k) time(promise.scene, method);
  }

  void time(const Scene& scene, const Method& method) {
    Simulation simulation(scene, method, {.threads = advice_.threads});
    simulation.observe([&] { return goesOn(fraction_); });
    const double start = plan_.clock(advice_.threads);
    simulation.advanceTo(scene.duration);
    advice_.measured = std::fmin(advice_.measured, plan_.clock(advice_.threads) - start);
  }

  const Scene& scene_;
  const AdvicePlan& plan_;
  double size_;  // m, of the sheet
  Truth truth_;
  std::optional<SettingSearch> search_;
  Advice advice_;
  double fraction_ = 0;
};

}  // namespace

Advice quickAdvice(const Scene& scene, const AdvicePlan& plan) { return Adviser(scene, plan).quick(); }

Advice adviseOn(const Scene& scene, const AdvicePlan& plan) { return Adviser(scene, plan).proven(); }

}  // namespace tyg

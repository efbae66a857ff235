// The quick study, the proof, and what is said around them.
#include "study/advice.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "study/error.h"
#include "study/stability.h"
#include "tyg/methods.h"
#include "tyg/sheet.h"

namespace tyg {
namespace {

// Shares of the whole work.
constexpr double kStudyShare = 0.4, kReferenceShare = 0.5;
/// The quick study knows the truth and the machine only so well.
constexpr double kErrorMargin = 0.9, kBudgetMargin = 0.9;

class Adviser {
 public:
  Adviser(const Scene& scene, const AdvicePlan& plan) : scene_(scene), plan_(plan) { advice_.request = plan.request; }

  Advice quick() {
    chooseThreads();
    const SampledMotion truth = quickTruth();
    if (!advice_.stopped) study(truth);
    return advice_;
  }

  Advice proven() {
    quick();
    if (advice_.stopped || !advice_.promise) return advice_;
    const Reference reference = makeReference(
        scene_, advice_.threads, [&](double fraction) { return goesOn(kStudyShare + kReferenceShare * fraction); });
    if (advice_.stopped) return advice_;
    advice_.proven = reference.usable();
    if (!advice_.proven) return advice_;
    prove(reference);
    if (plan_.request.error > 0 && advice_.met && !advice_.held && !advice_.stopped) {
      advice_.secondTry = true;
      advice_.missed = advice_.achieved;
      study(reference.motion);
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

  /// One run of an adaptive method, far more exact than what is asked for, far cheaper than a reference.
  SampledMotion quickTruth() {
    constexpr double kOfTheError = 1e-3, kLoosest = 1e-6, kTightest = 1e-12;  // the last two of the size
    const double size = makeSheet(scene_).size();
    Scene scene = scene_;
    scene.precision = Precision::Double;
    const double wanted = plan_.request.error > 0 ? kOfTheError * plan_.request.error / 10 : kTightest * size;
    scene.tolerance = std::clamp(wanted, kTightest * size, kLoosest * size);
    return sampledRun(scene, findMethod("dopri54"), sampleTimes(scene_),
                      {.threads = advice_.threads,
                       .observer = [&](double time) { return goesOn(0.1 * kStudyShare * time / scene_.duration); }});
  }

  void study(const SampledMotion& truth) {
    SearchPlan plan;
    plan.methods = plan_.methods;
    plan.precisions = plan_.precisions;
    plan.threads = advice_.threads;
    plan.cost = plan_.cost;
    plan.mostSeconds = plan_.mostSeconds;
    plan.allSeconds = plan_.allSeconds;
    const SettingSearch* runs = nullptr;
    plan.observer = [&] {
      const double share = 1 - 1 / (1 + 0.1 * (runs == nullptr ? 0 : runs->runs()));
      return goesOn(kStudyShare * (0.1 + 0.9 * share));
    };
    SettingSearch search(scene_, truth, std::move(plan));
    runs = &search;
    choose(search);
    if (advice_.promise && (advice_.met || plan_.request.budget > 0) && !search.stopped()) {
      const double better = 0.1 * (plan_.request.error > 0 ? plan_.request.error : advice_.promise->error);
      advice_.tenTimesBetter = search.cheapestWithin(kErrorMargin * better);
    }
    advice_.runs += search.runs();
    if (advice_.promise) advice_.limit = restLatticeLimit(scene_, findMethod(advice_.promise->scene.integrator));
  }

  void choose(SettingSearch& search) {
    if (plan_.request.error > 0) {
      advice_.promise = search.cheapestWithin(kErrorMargin * plan_.request.error);
      advice_.met = advice_.promise.has_value();
      if (!advice_.met) advice_.promise = search.leastError();
    } else {
      const double whole = plan_.request.budget * scene_.duration / kFrame;
      advice_.promise = search.mostExactWithin(kBudgetMargin * whole);
      advice_.met = advice_.promise.has_value();
      if (!advice_.met) advice_.promise = search.cheapest();
    }
  }

  void prove(const Reference& reference) {
    const Trial& promise = *advice_.promise;
    const Method& method = findMethod(promise.scene.integrator);
    const auto observer = [&](double time) {
      return goesOn(kStudyShare + kReferenceShare + 0.05 * time / scene_.duration);
    };
    const SampledMotion run =
        sampledRun(promise.scene, method, reference.motion.times, {.threads = advice_.threads, .observer = observer});
    advice_.achieved = motionError(run, reference.motion).rms;
    advice_.floor = reference.floorOf(promise.scene.precision);
    const double cost = static_cast<double>(workOf(method, run)) * plan_.cost(promise.scene, advice_.threads);
    constexpr double kNear = 1.1;  // of what was found nearest to a request that cannot be met
    if (plan_.request.error > 0) {
      advice_.held = advice_.achieved <= (advice_.met ? plan_.request.error : kNear * promise.error);
    } else {
      const double asked = advice_.met ? plan_.request.budget : kNear * frameSeconds(promise.seconds, scene_.duration);
      advice_.held = frameSeconds(cost, scene_.duration) <= asked;
    }
    constexpr int kRepeats = 3;
    for (int k = 0; k < kRepeats && !advice_.stopped; ++k) time(promise.scene, method);
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
  Advice advice_;
  double fraction_ = 0;
};

}  // namespace

Advice quickAdvice(const Scene& scene, const AdvicePlan& plan) { return Adviser(scene, plan).quick(); }

Advice adviseOn(const Scene& scene, const AdvicePlan& plan) { return Adviser(scene, plan).proven(); }

}  // namespace tyg

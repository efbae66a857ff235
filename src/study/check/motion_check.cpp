// The truth, the errors, and the verdict: a program is accused only where a mistake explains what no right method does.
#include "study/check/motion_check.h"

#include <algorithm>
#include <cmath>
#include <thread>

#include "study/check/explanation_search.h"
#include "study/limits/stability.h"
#include "study/motion/error.h"
#include "study/motion/tearing.h"
#include "tyg/methods.h"
#include "util/workers.h"

namespace tyg {
namespace {

constexpr double kReferenceTolerance = 1e-12, kAgreement = 1e-10;  // of the size
constexpr double kTruthEnds = 0.35, kSearchBegins = 0.45;          // shares of the work
constexpr double kClearlyNearer = 30;  // times: what is not exact explains a motion only where it is so much nearer

int threadsOf(const CheckOptions& options) {
  return options.threads > 0 ? options.threads : std::max(1, int(std::thread::hardware_concurrency()));
}

/// The threads that share the rows of one run: of a small sheet they would only wait for each other.
int rowThreadsOf(const CheckOptions& options, const Scene& scene) {
  return defaultThreads(scene.columns * scene.rows) == 1 ? 1 : options.threads;
}

/// The truth at the motion's own times.
SampledMotion truthAt(const MotionCheck& check, const GivenMotion& motion, const CheckOptions& options) {
  Scene scene = check.reference.scene;
  std::vector<double> times;
  for (const double time : motion.times) {
    if (time > 0) times.push_back(time);
  }
  const auto observer = [&](double time) {
    const double share = time / scene.duration;
    return !options.observer || options.observer(kTruthEnds + (kSearchBegins - kTruthEnds) * share);
  };
  return sampledRun(scene, findMethod("dopri54"), times,
                    {.threads = rowThreadsOf(options, scene), .observer = observer});
}

void measureErrors(MotionCheck& check, const GivenMotion& motion, const CheckOptions& options) {
  const SampledMotion truth = truthAt(check, motion, options);
  check.stopped = check.stopped || truth.stopped;
  const std::size_t before = motion.times.size() - std::min(motion.times.size(), truth.times.size());
  check.errors.assign(before, 0.0);  // t = 0 alone
  for (std::size_t k = 0; k < truth.positions.size() && before + k < motion.positions.size(); ++k) {
    check.errors.push_back(distanceBetween(motion.positions[before + k], truth.positions[k]).rms);
  }
  check.error = check.errors.empty() ? 0 : std::ranges::max(check.errors);
}

/// The motion as far as it is certain what tears.
GivenMotion judgedPart(const Scene& scene, GivenMotion motion) {
  while (motion.times.size() > 1 && motion.times.back() > scene.duration * (1 + 1e-9) + motion.timeRounding) {
    motion.times.pop_back();
    motion.positions.pop_back();
    motion.rounding.pop_back();
  }
  return motion;
}

bool isReportsRk4(const Explanation& of) { return of.way.name() == "report-rk4"; }

void decide(MotionCheck& check, ExplanationSearch& search, const CheckOptions& options) {
  using Verdict = MotionCheck::Verdict;
  const auto isExactlyRight = [&] {
    if (!check.right || !check.right->exact) return false;
    check.verdict = isReportsRk4(*check.right) ? Verdict::Mistaken : Verdict::Right;
    if (check.verdict == Verdict::Mistaken) check.mistaken = check.right;
    return true;
  };
  check.right = search.right();
  if (isExactlyRight() || search.stopped()) return;
  const double nearest = std::min(check.error, check.right ? check.right->distance : check.error);
  double first = 0;
  for (std::size_t k = 0; k < search.first(); ++k) first = std::max(first, check.errors[k]);
  const std::optional<Explanation> found = search.mistaken(first);
  if (found && found->exact && found->model.made.empty()) check.right = found;
  if (isExactlyRight()) return;
  if ((!found || !found->exact) && !search.stopped()) {
    if (const std::optional<Explanation> other = search.rightAtAnyStep()) check.right = other;
    if (isExactlyRight()) return;
  }
  const bool isNear = check.right && check.right->distance < check.error / kClearlyNearer;
  if (found && (found->exact || (!isNear && found->distance < nearest / kClearlyNearer))) {
    check.verdict = Verdict::Mistaken;
    check.mistaken = found;
  } else if (isNear) {
    check.verdict = Verdict::Right;
  } else {
    check.verdict = check.error <= options.fine * check.size ? Verdict::OtherMethod : Verdict::Unexplained;
  }
}

}  // namespace

const Explanation* MotionCheck::explanation() const { return mistaken ? &*mistaken : right ? &*right : nullptr; }

bool MotionCheck::truthIsAsNear() const {
  constexpr double kAsNear = 3;  // times
  const Explanation* of = explanation();
  return of != nullptr && error <= kAsNear * of->distance;
}

bool MotionCheck::stepIsTooLong() const {
  const Explanation* of = explanation();
  return of != nullptr && limit > 0 && of->dt > limit;
}

MotionCheck checkMotion(const Scene& scene, const GivenMotion& handedIn, const CheckOptions& options) {
  MotionCheck check;
  check.scene = scene;
  check.scene.duration = handedIn.times.back();
  check.scene.precision = Precision::Double;
  check.size = makeSheet(scene).size();
  const auto part = [&](double from, double to) {
    return
        [&options, from, to](double done) { return !options.observer || options.observer(from + (to - from) * done); };
  };
  constexpr double kTears = 0.05;
  const int threads = rowThreadsOf(options, scene);
  const Tearing tearing = untilTearsDiffer(check.scene, threads, part(0, kTears));
  check.scene = tearing.scene;
  check.tears = tearing.words();
  const GivenMotion motion = judgedPart(check.scene, handedIn);
  check.reference = makeReference(
      check.scene, threads, part(kTears, kTruthEnds),
      {.tolerance = kReferenceTolerance * check.size, .agreement = kAgreement * check.size, .patience = 2});
  check.stopped = check.reference.stopped;
  if (check.stopped) return check;
  if (!check.reference.usable()) {
    throw InputError(scene.name + ": found no exact motion to compare with: " + check.reference.whyUnusable() +
                     "; allowed: a scene that dopri54 and rk4 can both follow, or a shorter --duration");
  }
  measureErrors(check, motion, options);
  if (check.stopped) return check;
  ExplanationSearch search(check.scene, motion, options.dt, threadsOf(options), part(kSearchBegins, 1));
  decide(check, search, options);
  if (const Explanation* of = check.explanation()) check.explained = search.distances(*of);
  if (check.mistaken) check.withoutMistake = search.withoutMistake(*check.mistaken);
  check.stopped = search.stopped();
  if (check.stopped) return check;
  if (const Explanation* of = check.explanation(); of != nullptr && of->way.known() && of->dt > 0) {
    const double limit = restLatticeLimit(of->model.scene, findMethod(of->way.name()));
    check.limit = limit > 0 ? limit : 0;
  }
  return check;
}

}  // namespace tyg

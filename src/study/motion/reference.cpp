// The reference, its second opinion and its twin.
#include "study/motion/reference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "study/limits/stability.h"
#include "study/motion/error.h"
#include "tyg/methods.h"
#include "util/text.h"

namespace tyg {
namespace {

constexpr double kReferenceTolerance = 1e-13;  // of the size; below it rounding takes over
constexpr double kLoosestTolerance = 1e-11;    // the twin's distance must stay far above it
constexpr double kTwinDistance = 1e-9;         // of the size

/// Shares of the whole work, about as measured.
constexpr double kMainShare = 0.2, kTwinShare = 0.2, kRungShare = 0.5;

class ReferenceMaker {
 public:
  ReferenceMaker(Scene scene, int threads, const std::function<bool(double)>& observer, const ReferenceAim& aim)
      : threads_(threads), patience_(aim.patience), observer_(observer) {
    const double size = reference_.size = makeSheet(scene).size();
    scene.precision = Precision::Double;
    scene.tolerance = std::clamp(aim.tolerance, kReferenceTolerance * size, kLoosestTolerance * size);
    if (aim.motion != nullptr && scene.tolerance == aim.tolerance) reference_.motion = *aim.motion;
    agreement_ = std::max(aim.agreement, scene.tolerance / 2);
    reference_.scene = std::move(scene);
    times_ = sampleTimes(reference_.scene);
  }

  Reference make() {
    if (reference_.motion.times.empty()) {
      reference_.motion = run(reference_.scene, findMethod("dopri54"), kMainShare);
    }
    reference_.bulk = bulkOf(reference_.motion);
    if (complete(reference_.motion)) measureAmplification();
    if (complete(reference_.motion)) askSecondOpinion();
    return std::move(reference_);
  }

 private:
  [[nodiscard]] bool complete(const SampledMotion& motion) const {
    return !reference_.stopped && motion.times.size() == times_.size();
  }

  SampledMotion run(const Scene& scene, const Method& method, double share) {
    const auto observer = [&](double time) { return observer_(done_ + share * time / scene.duration); };
    SampledMotion motion = sampledRun(scene, method, times_, {.threads = threads_, .observer = observer});
    reference_.stopped = reference_.stopped || motion.stopped;
    done_ += share;
    return motion;
  }

  void measureAmplification() {
    const double distance = kTwinDistance * reference_.size;
    const SampledMotion twin = run(twinOf(reference_.scene, distance), findMethod("dopri54"), kTwinShare);
    for (std::size_t k = 0; k < twin.positions.size(); ++k) {
      const double apart = distanceBetween(twin.positions[k], reference_.motion.positions[k]).rms;
      reference_.amplification.push_back(apart / distance);
    }
    reference_.twinBulk = bulkOf(twin);
    // A twin that failed is as lost as one can be.
    reference_.amplification.resize(times_.size(), 1 / kTwinDistance);
  }

  /// The classical Runge-Kutta method shares neither coefficients nor step control with the reference. Its step shrinks
  /// until it comes as close as is asked for, or gains no more, or costs too much.
  void askSecondOpinion() {
    const Method& method = findMethod("rk4");
    const double interval = times_.front(), limit = restLatticeLimit(reference_.scene, method);
    constexpr double kFirstOfLimit = 0.25, kWithoutLimit = 64, kGain = 4;
    const double most = mostEvaluations() / (method.evaluationsPerStep * static_cast<double>(times_.size()));
    double count = limit > 0 ? std::ceil(interval / (kFirstOfLimit * limit)) : kWithoutLimit;
    double apart = disagreementAt(count);
    while (!reference_.stopped && !(apart <= agreement_) && 2 * count <= most) {
      const double factor = std::isnan(apart) ? 4 : std::ceil(std::pow(apart / agreement_, 1.0 / method.order));
      count *= std::clamp(factor, 2.0, std::min(8.0, std::floor(most / count)));
      const double before = std::exchange(apart, disagreementAt(count));
      if (apart > before / kGain) break;
    }
  }

  /// What the second opinion may cost: some times the reference itself, and small sheets cost next to nothing.
  [[nodiscard]] double mostEvaluations() const {
    constexpr double kParticleEvaluations = 2e7;
    const double particles = double(reference_.scene.columns) * reference_.scene.rows;
    return std::max(patience_ * double(reference_.motion.forceEvaluations), kParticleEvaluations / particles);
  }

  /// At the end of the run; NaN where the second method failed.
  double disagreementAt(double stepsPerSample) {
    Scene scene = reference_.scene;
    scene.dt = times_.front() / stepsPerSample;
    const SampledMotion second = run(scene, findMethod("rk4"), kRungShare * (1 - done_));
    reference_.secondStep = second.largestStep;
    reference_.disagreement.clear();
    if (!complete(second)) return std::numeric_limits<double>::quiet_NaN();
    double largest = 0;
    for (std::size_t k = 0; k < times_.size(); ++k) {
      largest = std::max(largest, distanceBetween(second.positions[k], reference_.motion.positions[k]).rms);
      reference_.disagreement.push_back(largest);
    }
    return largest;
  }

  int threads_;
  double patience_;
  const std::function<bool(double)>& observer_;
  double agreement_ = 0;  // m
  Reference reference_;
  std::vector<double> times_;
  double done_ = 0;
};

/// Half the distance between 1 and the next number.
double roundingUnit(Precision precision) {
  return precision == Precision::Float ? double(std::numeric_limits<float>::epsilon()) / 2
                                       : std::numeric_limits<double>::epsilon() / 2;
}

std::size_t firstAfter(const std::vector<double>& times, double time) {
  return static_cast<std::size_t>(std::ranges::upper_bound(times, time) - times.begin());
}

}  // namespace

double errorFloor(double size, double amplification, double disagreement, Precision precision) {
  return std::min(size, std::max(disagreement, amplification * roundingUnit(precision) * size));
}

std::string Reference::whyUnusable() const {
  if (motion.status != Status::Ok) {
    return formatted("dopri54 within %.3g m a step was ", scene.tolerance) + std::string(nameOf(motion.status));
  }
  return formatted("rk4 was unstable with steps of %.3g s", secondStep);
}

bool Reference::usable() const {
  return !stopped && motion.status == Status::Ok && !motion.times.empty() && disagreement.size() == motion.times.size();
}

double Reference::floorAt(std::size_t sample, Precision precision) const {
  double amplified = 1;  // at the start
  for (std::size_t k = 0; k <= sample; ++k) amplified = std::max(amplified, amplification[k]);
  return errorFloor(size, amplified, disagreement[sample], precision);
}

BulkDistance Reference::distanceAfter(double horizon, const SampledMotion& run) const {
  return bulkDistance(bulkOf(run), bulk, firstAfter(motion.times, horizon));
}

BulkDistance Reference::bandAfter(double horizon, Precision precision) const {
  BulkDistance band = bulkDistance(twinBulk, bulk, firstAfter(motion.times, horizon));
  const double wider =
      std::ranges::max(amplification) > kTwinLost ? 1 : std::max(1.0, roundingUnit(precision) / kTwinDistance);
  band.centre *= wider, band.gyration *= wider, band.energy *= wider;
  return band;
}

double Reference::horizonOf(double error, Precision precision) const {
  double horizon = 0;
  for (std::size_t k = 0; k < motion.times.size(); ++k) {
    if (meansSomething(error, floorAt(k, precision))) horizon = motion.times[k];
  }
  return horizon;
}

Reference makeReference(Scene scene, int threads, const std::function<bool(double)>& observer,
                        const ReferenceAim& aim) {
  return ReferenceMaker(std::move(scene), threads, observer, aim).make();
}

Scene twinOf(Scene scene, double distance) {
  const Sheet sheet = makeSheet(scene);
  std::mt19937 numbers(1);
  const auto number = [&] { return 2 * double(numbers()) / double(std::mt19937::max()) - 1; };
  std::vector<Displacement> moved;
  double sum = 0;
  for (int particle = 0; particle < sheet.count(); ++particle) {
    if (std::ranges::binary_search(sheet.pins, particle)) continue;
    const double x = number(), y = number(), z = number();
    sum += x * x + y * y + z * z;
    moved.push_back({{"", particle % sheet.columns, particle / sheet.columns}, {x, y, z}});
  }
  const double scale = distance / std::sqrt(sum / sheet.count());
  for (Displacement& one : moved) one.by = {scale * one.by.x, scale * one.by.y, scale * one.by.z};
  scene.displacements.insert(scene.displacements.end(), moved.begin(), moved.end());
  return scene;
}

}  // namespace tyg

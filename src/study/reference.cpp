// The reference, its second opinion and its twin.
#include "study/reference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "study/error.h"
#include "study/stability.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

constexpr double kReferenceTolerance = 1e-13;                 // of the size; below it rounding takes over
constexpr double kTwinDistance = 1e-9, kTwinFarthest = 1e-3;  // of the size

/// Shares of the whole work, about as measured.
constexpr double kMainShare = 0.2, kTwinShare = 0.2, kFirstTryShare = 0.1;

class ReferenceMaker {
 public:
  ReferenceMaker(Scene scene, int threads, const std::function<bool(double)>& observer)
      : threads_(threads), observer_(observer) {
    reference_.size = makeSheet(scene).size();
    scene.precision = Precision::Double;
    scene.tolerance = kReferenceTolerance * reference_.size;
    reference_.scene = std::move(scene);
    times_ = sampleTimes(reference_.scene);
  }

  Reference make() {
    reference_.motion = run(reference_.scene, findMethod("dopri54"), kMainShare);
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
    double amplification = 0;
    for (std::size_t k = 0; k < times_.size() && !std::isinf(amplification); ++k) {
      const bool gone = k >= twin.positions.size();
      const double apart = gone ? 0 : distanceBetween(twin.positions[k], reference_.motion.positions[k]).rms;
      const bool lost = gone || apart > kTwinFarthest * reference_.size;
      amplification = lost ? std::numeric_limits<double>::infinity() : apart / distance;
      reference_.amplification.push_back(amplification);
    }
    reference_.amplification.resize(times_.size(), amplification);
  }

  /// The classical Runge-Kutta method shares neither coefficients nor step control with the reference. A first try
  /// shows how far its step must shrink to come within the reference's tolerance.
  void askSecondOpinion() {
    const Method& method = findMethod("rk4");
    const double interval = times_.front(), limit = restLatticeLimit(reference_.scene, method);
    constexpr double kFirstOfLimit = 0.25, kWithoutLimit = 64, kMostRefinement = 64;
    const double first = limit > 0 ? std::ceil(interval / (kFirstOfLimit * limit)) : kWithoutLimit;
    const double roughly = disagreementAt(first, kFirstTryShare);
    // What the cloth itself amplifies is not a fault of the step.
    const double amplified = std::clamp(std::ranges::max(reference_.amplification), 1.0, kTwinFarthest / kTwinDistance);
    const double wanted = amplified * kReferenceTolerance / 2 * reference_.size;
    const double ratio = roughly >= 0 ? std::pow(roughly / wanted, 1.0 / method.order) : kMostRefinement / 4;
    const double refinement = std::clamp(std::ceil(ratio), 2.0, kMostRefinement);
    disagreementAt(first * refinement, 1 - done_);
  }

  /// At the end of the run; NaN where the second method failed.
  double disagreementAt(double stepsPerSample, double share) {
    Scene scene = reference_.scene;
    scene.dt = times_.front() / stepsPerSample;
    const SampledMotion second = run(scene, findMethod("rk4"), share);
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
  const std::function<bool(double)>& observer_;
  Reference reference_;
  std::vector<double> times_;
  double done_ = 0;
};

/// Half the distance between 1 and the next number.
double roundingUnit(Precision precision) {
  return precision == Precision::Float ? double(std::numeric_limits<float>::epsilon()) / 2
                                       : std::numeric_limits<double>::epsilon() / 2;
}

}  // namespace

bool Reference::usable() const {
  return !stopped && motion.status == Status::Ok && !motion.times.empty() && disagreement.size() == motion.times.size();
}

double Reference::floorAt(std::size_t sample, Precision precision) const {
  double amplified = 1;  // at the start
  for (std::size_t k = 0; k <= sample; ++k) amplified = std::max(amplified, amplification[k]);
  return std::max(disagreement[sample], amplified * roundingUnit(precision) * size);
}

double Reference::horizonOf(double error, Precision precision) const {
  double horizon = 0;
  for (std::size_t k = 0; k < motion.times.size(); ++k) {
    if (floorAt(k, precision) < error / 10) horizon = motion.times[k];
  }
  return horizon;
}

Reference makeReference(Scene scene, int threads, const std::function<bool(double)>& observer) {
  return ReferenceMaker(std::move(scene), threads, observer).make();
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

// Up to three kinds of runs make a reference: the motion itself, a twin that starts a little beside it, and a second
// opinion by another method, which is asked again with shorter steps until the two agree.
#include "study/motion/reference.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "study/limits/stability.h"
#include "study/motion/error.h"
#include "study/motion/progress.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

constexpr double kReferenceTolerance = 1e-13;  // of the size; below it rounding takes over
constexpr double kLoosestTolerance = 1e-11;    // the twin's distance must stay far above it
constexpr double kTwinDistance = 1e-9;         // of the size

/// Shares of the whole work, about as measured.
constexpr double kMainShare = 0.2, kTwinShare = 0.2, kRungShare = 0.5;

/// What all runs for one reference share.
struct Runs {
  std::vector<double> times;  // s
  int threads;
  Progress progress;
};

bool complete(const SampledMotion& motion, const Runs& runs) {
  return !runs.progress.stopped() && motion.times.size() == runs.times.size();
}

/// A run that is this share of the whole work.
SampledMotion runOf(const Scene& scene, const Method& method, double share, Runs& runs) {
  const double done = runs.progress.fraction();
  const auto observer = [&](double time) { return runs.progress.reach(done + share * time / scene.duration); };
  SampledMotion motion = sampledRun(scene, method, runs.times, {.threads = runs.threads, .observer = observer});
  runs.progress.advanceTo(done + share);
  return motion;
}

/// The scene in double, with the tolerance that the reference is run with.
Scene referenceScene(Scene scene, double size, double tolerance) {
  scene.precision = Precision::Double;
  scene.tolerance = std::clamp(tolerance, kReferenceTolerance * size, kLoosestTolerance * size);
  return scene;
}

/// The motion that starts a little beside the reference's.
struct Twin {
  std::vector<double> amplification;  // as Reference::amplification
  std::vector<Bulk> bulk;
};

Twin twinBeside(const Reference& reference, Runs& runs) {
  const double distance = kTwinDistance * reference.size;
  const SampledMotion motion = runOf(twinOf(reference.scene, distance), findMethod("dopri54"), kTwinShare, runs);
  Twin twin;
  for (std::size_t k = 0; k < motion.positions.size(); ++k) {
    const double apart = distanceBetween(motion.positions[k], reference.motion.positions[k]).rms;
    twin.amplification.push_back(apart / distance);
  }
  twin.bulk = bulkOf(motion);
  // A twin that failed is as lost as one can be.
  twin.amplification.resize(runs.times.size(), 1 / kTwinDistance);
  return twin;
}

/// What another method makes of the scene.
struct SecondOpinion {
  double step = 0;                   // s
  std::vector<double> disagreement;  // as Reference::disagreement; empty where that method failed or was stopped

  /// m, at the end of the run; NaN where there is none.
  [[nodiscard]] double apart() const {
    return disagreement.empty() ? std::numeric_limits<double>::quiet_NaN() : disagreement.back();
  }
};

SecondOpinion opinionWith(double stepsPerSample, const Reference& reference, Runs& runs) {
  Scene scene = reference.scene;
  scene.dt = runs.times.front() / stepsPerSample;
  const SampledMotion motion = runOf(scene, findMethod("rk4"), kRungShare * (1 - runs.progress.fraction()), runs);
  SecondOpinion opinion{.step = motion.largestStep, .disagreement = {}};
  if (!complete(motion, runs)) return opinion;
  double largest = 0;
  for (std::size_t k = 0; k < runs.times.size(); ++k) {
    largest = std::max(largest, distanceBetween(motion.positions[k], reference.motion.positions[k]).rms);
    opinion.disagreement.push_back(largest);
  }
  return opinion;
}

/// What the second opinion may cost: some times the reference itself, and small sheets cost next to nothing.
double mostEvaluations(const Reference& reference, double patience) {
  constexpr double kParticleEvaluations = 2e7;
  const double particles = double(reference.scene.columns) * reference.scene.rows;
  return std::max(patience * double(reference.motion.forceEvaluations), kParticleEvaluations / particles);
}

/// The classical Runge-Kutta method shares neither coefficients nor step control with the reference. Its step shrinks
/// until it comes as close as is asked for, or gains no more, or costs too much.
SecondOpinion secondOpinionOn(const Reference& reference, const ReferenceAim& aim, Runs& runs) {
  const Method& method = findMethod("rk4");
  const double agreement = std::max(aim.agreement, reference.scene.tolerance / 2);
  const double interval = runs.times.front(), limit = restLatticeLimit(reference.scene, method);
  constexpr double kFirstOfLimit = 0.25, kWithoutLimit = 64, kGain = 4;
  const double most =
      mostEvaluations(reference, aim.patience) / (method.evaluationsPerStep * static_cast<double>(runs.times.size()));
  double count = limit > 0 ? std::ceil(interval / (kFirstOfLimit * limit)) : kWithoutLimit;
  SecondOpinion opinion = opinionWith(count, reference, runs);
  while (!runs.progress.stopped() && !(opinion.apart() <= agreement) && 2 * count <= most) {
    const double before = opinion.apart();
    const double factor = std::isnan(before) ? 4 : std::ceil(std::pow(before / agreement, 1.0 / method.order));
    count *= std::clamp(factor, 2.0, std::min(8.0, std::floor(most / count)));
    opinion = opinionWith(count, reference, runs);
    if (opinion.apart() > before / kGain) break;
  }
  return opinion;
}

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
    return fmt::format("dopri54 within {:.3g} m a step was {}", scene.tolerance, nameOf(motion.status));
  }
  return fmt::format("rk4 was unstable with steps of {:.3g} s", secondStep);
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

void refuseEndlessReference(const Scene& scene) {
  constexpr double kMostReferenceSteps = 1e8;  // of one particle alone they take a minute
  const double limit = restLatticeLimit(scene, findMethod("dopri54")), steps = scene.duration / limit;
  if (!(steps > kMostReferenceSteps)) return;
  throw InputError(
      fmt::format("{}: found springs, damping and mass that hold dopri54 to steps of {:.1g} s, {:.1g} of them for a "
                  "motion to measure errors against; allowed are scenes that need {:g} at most",
                  scene.name, limit, steps, kMostReferenceSteps));
}

Reference makeReference(const Scene& scene, int threads, const std::function<bool(double)>& observer,
                        const ReferenceAim& aim) {
  refuseEndlessReference(scene);
  Reference reference;
  reference.size = makeSheet(scene).size();
  reference.scene = referenceScene(scene, reference.size, aim.tolerance);
  Runs runs{.times = sampleTimes(scene), .threads = threads, .progress = Progress(observer)};
  const bool isGiven =
      aim.motion != nullptr && !aim.motion->times.empty() && reference.scene.tolerance == aim.tolerance;
  reference.motion = isGiven ? *aim.motion : runOf(reference.scene, findMethod("dopri54"), kMainShare, runs);
  reference.bulk = bulkOf(reference.motion);
  if (complete(reference.motion, runs)) {
    Twin twin = twinBeside(reference, runs);
    reference.amplification = std::move(twin.amplification);
    reference.twinBulk = std::move(twin.bulk);
  }
  if (complete(reference.motion, runs)) {
    SecondOpinion opinion = secondOpinionOn(reference, aim, runs);
    reference.secondStep = opinion.step;
    reference.disagreement = std::move(opinion.disagreement);
  }
  reference.stopped = runs.progress.stopped();
  return reference;
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

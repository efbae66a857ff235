// A model runs in Tyg where a scene holds it, else in the student's program; both take steps of exactly dt.
#include "study/check/trial.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "study/motion/error.h"
#include "study/motion/reference.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg {
namespace {

constexpr double kTwinDistance = 1e-9;  // of the size

/// A model in motion.
class Runner {
 public:
  Runner(const Trial& trial, const Scene& scene) : adaptive_(trial.way.adaptive() && trial.dt == 0) {
    Scene run = scene;
    if (!adaptive_) run.dt = trial.dt, run.tolerance = 0;
    run.precision = Precision::Double;
    if (trial.way.method != nullptr) {
      simulation_.emplace(run, *trial.way.method, Settings{.threads = 1, .keepGoing = true});
    } else {
      program_.emplace(run, trial.model->habits, *trial.way.student, trial.dt);
    }
  }
  /// False where the numbers have left what can be computed with, or `goesOn` said stop.
  bool advanceTo(double time, std::int64_t steps, const std::function<bool()>& goesOn) {
    if (simulation_) {
      if (goesOn) simulation_->observe(goesOn);
      adaptive_ ? simulation_->advanceTo(time) : simulation_->tick(steps - done_);
      done_ = steps;
      return simulation_->status() != Status::NotFinite;
    }
    constexpr int kAsk = 64;
    for (; done_ < steps; ++done_) {
      if (done_ % kAsk == 0 && goesOn && !goesOn()) return false;
      program_->step();
    }
    return true;
  }
  const std::vector<Vec3>& positions() {
    if (program_) return program_->positions();
    const int count = simulation_->sheet().count();
    positions_.clear();
    for (int particle = 0; particle < count; ++particle) positions_.push_back(simulation_->position(particle));
    return positions_;
  }

 private:
  bool adaptive_;
  std::optional<Simulation> simulation_;
  std::optional<StudentProgram> program_;
  std::int64_t done_ = 0;
  std::vector<Vec3> positions_;
};

std::size_t springsIn(const Scene& scene) {
  const Sheet sheet = makeSheet(scene);
  long long springs = sheet.count();
  if (scene.structural.present()) springs += springCount(sheet, Family::Structural);
  if (scene.shear.present()) springs += springCount(sheet, Family::Shear);
  if (scene.bend.present()) springs += springCount(sheet, Family::Bend);
  return std::size_t(springs);
}

bool isMultiStage(const StudentMethod& method) { return method.evaluations > 1 || method.name.starts_with("leapfrog"); }

}  // namespace

double Fit::upTo(std::size_t samples) const {
  if (distances.size() < samples) return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (std::size_t k = 0; k < samples; ++k) largest = std::max(largest, distances[k]);
  return largest;
}

Fit fitOf(const Trial& trial, const GivenMotion& motion, const FitOptions& options) {
  Fit fit;
  const std::vector<std::int64_t> counts =
      trial.dt > 0 ? stepCounts(motion, trial.dt) : std::vector<std::int64_t>(motion.times.size());
  if (counts.empty()) return fit;
  const Scene& scene = trial.model->scene;
  const double size = makeSheet(scene).size();
  std::optional<Runner> runner, twin;
  try {
    runner.emplace(trial, scene);
    if (options.twin) twin.emplace(trial, twinOf(scene, kTwinDistance * size));
  } catch (const InputError&) {
    return fit;  // not a scene for this method
  }
  for (std::size_t k = 0; k < options.samples; ++k) {
    if (options.goesOn && !options.goesOn()) {
      fit.stopped = true;
      break;
    }
    if (!runner->advanceTo(motion.times[k], counts[k], options.goesOn)) break;
    const std::vector<Vec3>& at = runner->positions();
    const double apart = distanceBetween(at, motion.positions[k]).rms;
    if (!std::isfinite(apart)) break;
    fit.distances.push_back(apart);
    if (k + 1 == options.samples) fit.last = at;
    if (apart > options.enough) break;
    if (!twin) continue;
    const bool goesOn = twin->advanceTo(motion.times[k], counts[k], options.goesOn);
    const double spread = goesOn ? distanceBetween(twin->positions(), at).rms / (kTwinDistance * size) : 1;
    const double before = fit.amplification.empty() ? 1 : fit.amplification.back();
    fit.amplification.push_back(goesOn && std::isfinite(spread) ? std::max(before, spread) : 1 / kTwinDistance);
  }
  fit.stopped = fit.stopped || (options.goesOn && !options.goesOn());
  return fit;
}

std::size_t firstSamples(const GivenMotion& motion, const Scene& scene) {
  constexpr double kMoved = 0.01;  // of the size
  const std::size_t least = motion.times.front() > 0 ? 1 : 2, all = motion.times.size();
  std::vector<Vec3> start;
  const Sheet sheet = makeSheet(scene);
  start.reserve(std::size_t(sheet.count()));
  for (int particle = 0; particle < sheet.count(); ++particle) start.push_back(sheet.startPosition(particle));
  std::size_t first = std::min(all, least);
  const auto moved = [&] { return distanceBetween(motion.positions[first - 1], start).rms; };
  while (first < std::max(least, all / 3) && moved() < kMoved * sheet.size()) ++first;
  return std::min(first, all);
}

double costOf(const Trial& trial, const GivenMotion& motion, std::size_t samples) {
  constexpr double kFaster = 8, kOverhead = 150;  // rows at once, of Tyg's own methods; of each evaluation
  constexpr double kSolving = 150, kAdaptiveSteps = 1000;
  const auto springs = double(springsIn(trial.model->scene));
  const double steps = trial.dt > 0 ? motion.times[samples - 1] / trial.dt : kAdaptiveSteps;
  if (trial.way.student != nullptr) return steps * springs * trial.way.student->evaluations;
  const Method& method = *trial.way.method;
  const double evaluations = method.solves ? kSolving : std::abs(method.evaluationsPerStep);
  return (steps * evaluations + 10) * (springs / kFaster + kOverhead);
}

std::vector<Way> waysOf(const Model& model, Breadth breadth) {
  constexpr std::size_t kSmall = 1000;  // springs: there the student's program is the faster one
  const bool canBeStudents = StudentProgram::takes(model.scene);
  const bool byTyg = model.isScene() && (!canBeStudents || springsIn(model.scene) > kSmall);
  // Leapfrog keeps a force from one step to the next. Where a push begins or ends in between, Tyg forms it anew, and
  // the student's program keeps it as it was: both are right.
  const auto isTwofold = [&](std::string_view name) {
    return model.isScene() && !model.scene.pushes.empty() && name == "leapfrog";
  };
  std::vector<Way> ways;
  const auto isStudents = [](const Method& method) {
    return std::ranges::any_of(studentMethods(), [&](const StudentMethod& one) { return one.name == method.name; });
  };
  for (const Method& method : methods()) {
    const bool all = model.isScene() && breadth == Breadth::All;
    if (isStudents(method) ? byTyg || isTwofold(method.name) : all) ways.push_back({&method, nullptr});
  }
  if (!canBeStudents) return ways;
  for (const StudentMethod& method : studentMethods()) {
    if (byTyg && method.known && !isTwofold(method.name)) continue;
    if (model.habits.stale && !isMultiStage(method)) continue;
    ways.push_back({nullptr, &method});
  }
  return ways;
}

}  // namespace tyg

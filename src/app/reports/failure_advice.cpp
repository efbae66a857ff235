// The advice after a failure: the smallest changes that help, tried on the scene before they are said.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "app/reports/run_report.h"
#include "core/scene/bodies.h"
#include "study/limits/measured_limit.h"
#include "study/limits/stability.h"
#include "tyg/methods.h"
#include "util/amounts.h"
#include "util/interrupt.h"
#include "util/text.h"
#include "viewer/cure.h"

namespace tyg {
namespace {

/// A change of the scene, as words such as `--dt 0.002`.
struct Way {
  std::string words;
  bool tried = false;  ///< it was run and held; else it is predicted to
};

/// The ways that are found, and what is tried for them.
class Ways {
 public:
  explicit Ways(const FinishedRun& run) : run_(run), scene_(run.simulation.scene()) {
    scene_.dt = run.simulation.dt();
    scene_.integrator = run.simulation.method().name;
  }

  /// The largest of `first` s, half of it, and so on, that holds; `isPredicted` where nothing can be tried.
  void addStep(double first, bool isPredicted = true) {
    constexpr int kHalvings = 12;
    constexpr double kMostSteps = 1e12;  // of a run: nobody waits for more
    for (int k = 0; k < kHalvings; ++k) {
      Scene scene = scene_;
      scene.dt = roundedDown(std::ldexp(first, -k));
      if (scene.duration / scene.dt > kMostSteps) return;
      const std::string words = fmt::format("--dt {:.2g}", scene.dt);
      if (take(words, scene, isPredicted)) return;
    }
  }
  /// The first of `first` m, that times `factor`, and so on, that holds.
  void addTolerance(double first, double factor) {
    constexpr int kTrials = 10;
    std::optional<Way> predicted;
    for (int k = 0; k < kTrials; ++k) {
      Scene scene = scene_;
      const std::string words = fmt::format("--tolerance {:.2g}", first * std::pow(factor, k));
      scene.tolerance = std::stod(words.substr(words.find(' ')));
      if (scene.tolerance > largestTolerance(scene)) break;
      const std::optional<bool> held = hold(scene);
      if (held && *held) return ways_.push_back({words, true});
      if (!held && !predicted) predicted = Way{words};
    }
    if (predicted) ways_.push_back(*predicted);
  }
  /// The first other method that holds with the present step.
  void addMethod(double step) {
    std::optional<Way> predicted;
    for (const Method& method : methods()) {
      const bool holds = !(restLatticeLimit(scene_, method) < 1.05 * step);
      if (method.adaptive || method.name == scene_.integrator || !holds || !takes(method, scene_)) continue;
      Scene scene = scene_;
      scene.integrator = method.name, scene.dt = step;
      const std::string words = fmt::format("--integrator {} with this step", method.name);
      const std::optional<bool> held = hold(scene);
      if (held && *held) return ways_.push_back({words, true});
      if (!held && !predicted) predicted = Way{words};
    }
    if (predicted) ways_.push_back(*predicted);
  }
  void addDouble() {
    Scene scene = scene_;
    scene.precision = Precision::Double;
    take("--precision double", scene, true);
  }

  [[nodiscard]] std::string sentence() const {
    if (ways_.empty()) return "No smaller step and no other method that was tried holds here.";
    const auto isTried = [](const Way& way) { return way.tried; };
    const bool all = std::ranges::all_of(ways_, isTried), none = std::ranges::none_of(ways_, isTried);
    std::string text = "Try ";
    for (std::size_t k = 0; k < ways_.size(); ++k) {
      text += (k > 0 ? ", or " : "") + ways_[k].words;
      if (!all && !none) text += ways_[k].tried ? " (tried: it holds)" : " (predicted to hold)";
    }
    if (all) return text + (ways_.size() > 1 ? "; each was tried and holds." : ", which was tried and holds.");
    return text + (none ? ", predicted to hold; it was not tried." : ".");
  }

 private:
  /// Whether the scene's motion holds to its end; nothing where that would take too long.
  [[nodiscard]] std::optional<bool> hold(const Scene& scene) const {
    if (run_.replayed) return {};
    const Method& method = findMethod(scene.integrator);
    constexpr double kSomeSeconds = 3e7, kSolve = 10;  // particles times force evaluations
    MeasurePlan plan;
    plan.mostWork = method.solves ? kSomeSeconds / kSolve : kSomeSeconds;
    plan.threads = run_.simulation.threads();
    plan.observer = [] { return !interrupted(); };
    return survives(scene, method, plan);
  }
  /// Whether the search for this way is over.
  bool take(const std::string& words, const Scene& scene, bool isPredicted) {
    const std::optional<bool> held = hold(scene);
    if (held && !*held) return false;
    if (held || isPredicted) ways_.push_back({words, held.has_value()});
    return true;
  }

  const FinishedRun& run_;
  Scene scene_;
  std::vector<Way> ways_;
};

std::string firstToFail(const Scene& scene, const StepLimit& limit) {
  return "the motion that fails first: " + describe(scene, limit);
}

/// A tolerance allows waves as small as itself: one of a thousandth of the spacing is too small for any alarm.
std::string toleranceAdvice(const FinishedRun& run, Ways& ways) {
  const Simulation& simulation = run.simulation;
  const Scene& scene = simulation.scene();
  ways.addTolerance(std::min(scene.tolerance / 10, 1e-3 * scene.spacing), 0.1);
  if (!(run.stableStep > 0)) return ways.sentence();
  return fmt::format(
      "Steps of {:.4g} s would hold at rest, but a tolerance of {:.2g} m is too large to keep to them; {}. {}",
      run.stableStep, scene.tolerance, firstToFail(scene, stepLimit(scene, simulation.method())), ways.sentence());
}

/// Where an adaptive method's steps left the numbers whole, they became too short.
bool wasHalted(const FinishedRun& run) {
  const Simulation& simulation = run.simulation;
  return simulation.method().adaptive && simulation.scene().tolerance > 0 && simulation.status() == Status::NotFinite &&
         std::isfinite(run.ledger.mechanical());
}

std::string haltAdvice(const Simulation& simulation, Ways& ways) {
  const double size = simulation.sheet().size(), tolerance = simulation.scene().tolerance;
  constexpr double kTightest = 1e-12;  // of the size
  ways.addTolerance(std::max(10 * tolerance, kTightest * size), 10);
  if (simulation.scene().precision == Precision::Float) ways.addDouble();
  return fmt::format(
      "{} was halted at t = {:.6g} s: the steps that keep its tolerance of {:.6g} m became so short that the run would "
      "not end. {}",
      simulation.method().name, simulation.alarmTime(), tolerance, ways.sentence());
}

/// No deformation allows so much less than the limit at rest.
bool roundingDecides(const Scene& scene, double step, double limit) {
  constexpr double kFarBelow = 1e-3;
  return scene.precision == Precision::Float && std::isfinite(limit) && step < kFarBelow * limit;
}

std::string roundingAdvice(double limit, Ways& ways) {
  ways.addDouble();
  ways.addStep(0.1 * limit);
  return fmt::format(
      "The predicted limit at rest is {:.4g} s: a step so far below it moves a particle by little more than the "
      "rounding of float. {}",
      limit, ways.sentence());
}

/// A step that was below the limit at rest, and failed all the same.
std::string deformedAdvice(double limit, double certified, double step, Ways& ways) {
  const bool holds = certified > 0 && certified < step;
  ways.addStep(holds ? certified : step / 2);
  return fmt::format(
      "The predicted limit of the sheet at rest, {:.4g} s, was kept, but a cloth far from rest allows less{}. {}",
      limit, holds ? fmt::format(" (up to {:.2g} s hold in any deformation)", roundedDown(certified)) : "",
      ways.sentence());
}

/// A step above the limit at rest.
std::string limitAdvice(const Simulation& simulation, const StepLimit& said, double limit, Ways& ways) {
  const Scene& scene = simulation.scene();
  const double step = simulation.largestStep();
  if (limit > 0) ways.addStep(0.9 * limit);
  ways.addMethod(step);
  if (limit == 0) {
    return fmt::format(
        "No step is predicted to be stable for it here: it holds only where damping is strong enough; {}. {}",
        firstToFail(scene, said), ways.sentence());
  }
  return fmt::format("The predicted limit at rest is {:.4g} s; {}. {}", limit, firstToFail(scene, said),
                     ways.sentence());
}

}  // namespace

std::string failureAdvice(const FinishedRun& run) {
  const Simulation& simulation = run.simulation;
  const Scene& scene = simulation.scene();
  Ways ways(run);
  if (wasHalted(run)) return haltAdvice(simulation, ways);
  const Method& method = simulation.method();
  const double step = simulation.largestStep(), limit = run.stableStep;
  const bool finite = simulation.status() == Status::Unstable;
  const std::string what =
      fmt::format("{} with steps of {:.6g} s {} at t = {:.6g} s. ", method.name, step,
                  finite ? "became unstable (the cloth gained energy by itself)" : "left the range of the numbers",
                  simulation.alarmTime());
  if (method.adaptive && scene.tolerance > 0) return what + toleranceAdvice(run, ways);
  if (std::isnan(limit)) {
    ways.addStep(step / 2, false);
    if (scene.precision == Precision::Float) ways.addDouble();
    ways.addMethod(step);
    return what + "No limit is predicted for it. " + ways.sentence();
  }
  if (roundingDecides(scene, step, limit)) return what + roundingAdvice(limit, ways);
  const StepLimit said = stepLimit(scene, method);
  return what + (limit >= step ? deformedAdvice(limit, said.certified, step, ways)
                               : limitAdvice(simulation, said, limit, ways));
}

}  // namespace tyg

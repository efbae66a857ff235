// The advice after a failure names the smallest change that is predicted to help.
#include "app/reports/run_report.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/core.h>

#include "app/reports/json.h"
#include "core/forces/term.h"
#include "study/diet/idle_terms.h"
#include "study/limits/stability.h"
#include "tyg/methods.h"
#include "util/text.h"
#include "viewer/cure.h"

namespace tyg {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::string stableStepLine(const FinishedRun& run) {
  if (std::isnan(run.stableStep)) return "stable step   no limit";
  if (run.stableStep == 0) return "stable step   none: this method holds only where every wave is damped";
  const double share = run.simulation.largestStep() / run.stableStep;
  return fmt::format(
      "stable step   up to {:.4g} s is predicted for the sheet at rest; this run used {}", run.stableStep,
      share < 2 ? fmt::format("{:.3g} % of that", 100 * share) : fmt::format("{:.0f} times that", share));
}

std::string valueText(const Parameter& parameter, const Scene& scene) {
  const Vec3 value = parameter.get(scene);
  return parameter.count == 1 ? fmt::format("{:.4g}", value.x)
                              : fmt::format("({:.4g}, {:.4g}, {:.4g})", value.x, value.y, value.z);
}

/// The times inside the run at which a scene's push begins or ends.
std::vector<double> pushEdges(const Scene& scene) {
  std::vector<double> edges{0, scene.duration};
  for (const Push& push : scene.pushes) {
    for (const double edge : {push.at, push.at + push.duration}) {
      if (edge > 0 && edge < scene.duration) edges.push_back(edge);
    }
  }
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

std::string accuracyAsked(const Simulation& simulation) {
  if (simulation.method().adaptive) return fmt::format("a tolerance of {:.6g} m", simulation.scene().tolerance);
  return fmt::format("a step of {:.6g} s", simulation.dt());
}

std::string sizeAndMethod(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  return fmt::format("{}: {} x {} particles, {} with {}, {}, {} thread{}", scene.title, scene.columns, scene.rows,
                     simulation.method().name, accuracyAsked(simulation), nameOf(scene.precision), simulation.threads(),
                     simulation.threads() == 1 ? "" : "s");
}

/// Energies and stretch, where they still say something: those of a run that has blown up are digits without meaning.
std::string energyLines(const FinishedRun& run) {
  const Ledger& now = run.ledger;
  constexpr double kMostMeaning = 9;  // of stretch: ten times its length
  const bool cloth = now.maxStretch <= kMostMeaning && std::isfinite(now.kinetic + now.elastic + now.gravitational);
  if (run.simulation.status() != Status::Ok && !cloth) {
    return "energy        without meaning: the cloth has flown apart (--json gives the numbers)\n";
  }
  std::string text =
      fmt::format("energy        kinetic {:.4g} J, elastic {:.4g} J, gravitational {:.4g} J, work of pushes {:.4g} J\n",
                  now.kinetic, now.elastic, now.gravitational, now.work);
  if (run.followsLoss) {
    text += fmt::format("ledger        dissipated {:.4g} J; drift {:.3g} of the run's energy scale of {:.4g} J\n",
                        now.dissipated, now.drift, now.scale);
  }
  return text + fmt::format("stretch       springs up to {:.3g} % longer than at rest (checked every 64 steps)\n",
                            100 * now.maxStretch);
}

std::string firstToFail(const Scene& scene, const StepLimit& limit) {
  return "the motion that fails first: " + describe(scene, limit);
}

/// A tolerance allows waves as small as itself: one of a thousandth of the spacing is too small for any alarm.
std::string toleranceAdvice(const Simulation& simulation, double limit) {
  const Scene& scene = simulation.scene();
  std::string again = fmt::format("Try --tolerance {:.2g}.", std::min(scene.tolerance / 10, 1e-3 * scene.spacing));
  if (!(limit > 0)) return again;
  return fmt::format(
      "Steps of {:.4g} s would hold at rest, but a tolerance of {:.2g} m is too large to keep to them; {}. {}", limit,
      scene.tolerance, firstToFail(scene, stepLimit(scene, simulation.method())), again);
}

/// Where an adaptive method's steps left the numbers whole, they became too short.
bool wasHalted(const FinishedRun& run) {
  const Simulation& simulation = run.simulation;
  return simulation.method().adaptive && simulation.scene().tolerance > 0 && simulation.status() == Status::NotFinite &&
         std::isfinite(run.ledger.kinetic + run.ledger.elastic);
}

std::string haltAdvice(const Simulation& simulation) {
  return fmt::format(
      "{} was halted at t = {:.6g} s: the steps that keep its tolerance of {:.6g} m became so short that the run would "
      "not end. Try a larger --tolerance{}.",
      simulation.method().name, simulation.alarmTime(), simulation.scene().tolerance,
      simulation.scene().precision == Precision::Float ? ", or --precision double" : "");
}

/// No deformation allows so much less than the limit at rest.
bool roundingDecides(const Scene& scene, double step, double limit) {
  constexpr double kFarBelow = 1e-3;
  return scene.precision == Precision::Float && std::isfinite(limit) && step < kFarBelow * limit;
}

std::string roundingAdvice(double limit) {
  return fmt::format(
      "The predicted limit at rest is {:.4g} s: a step so far below it moves a particle by little more than the "
      "rounding "
      "of float. Try --precision double, or --dt {:.2g}.",
      limit, roundedDown(0.1 * limit));
}

/// A step that was below the limit at rest, and failed all the same.
std::string deformedAdvice(double limit, double certified, double step) {
  const bool holds = certified > 0 && certified < step;
  return fmt::format(
      "The predicted limit of the sheet at rest, {:.4g} s, was kept, but a cloth far from rest allows less. Try --dt "
      "{:.2g}{}.",
      limit, roundedDown(holds ? certified : step / 2), holds ? ", which holds in any deformation" : "");
}

/// A step above the limit at rest.
std::string limitAdvice(const Simulation& simulation, const StepLimit& said, double limit, double step) {
  const Scene& scene = simulation.scene();
  const Method* other = methodThatHolds(scene, simulation.method(), step);
  const std::string change =
      other == nullptr ? "" : fmt::format("--integrator {}, predicted to hold with this step", other->name);
  if (limit == 0) {
    return fmt::format(
        "No step is predicted to be stable for it here: it holds only where damping is strong enough; {}. Try {}.",
        firstToFail(scene, said), change.empty() ? "another method with a smaller step" : change);
  }
  return fmt::format("The predicted limit at rest is {:.4g} s; {}. Try --dt {:.2g}{}.", limit, firstToFail(scene, said),
                     roundedDown(0.9 * limit), change.empty() ? "" : ", or " + change);
}

}  // namespace

std::string runJson(const FinishedRun& run) {
  const Simulation& simulation = run.simulation;
  const Scene& scene = simulation.scene();
  return jsonText({
      {"scene", scene.name},
      {"columns", scene.columns},
      {"rows", scene.rows},
      {"integrator", simulation.method().name},
      {"precision", nameOf(scene.precision)},
      {"threads", simulation.threads()},
      {"dt_asked", simulation.dt()},
      {"dt", simulation.largestStep()},
      {"steps", simulation.steps()},
      {"force_evaluations", simulation.forceEvaluations()},
      {"seconds", run.seconds},
      {"simulated_seconds", simulation.time()},
      {"kinetic_J", run.ledger.kinetic},
      {"elastic_J", run.ledger.elastic},
      {"gravitational_J", run.ledger.gravitational},
      {"work_J", run.ledger.work},
      {"dissipated_J", run.followsLoss ? run.ledger.dissipated : kUnknown},
      {"ledger_drift", run.followsLoss ? run.ledger.drift : kUnknown},
      {"max_stretch", run.ledger.maxStretch},
      {"stable_dt", run.stableStep},
      {"hash", hashText(simulation)},
      {"status", nameOf(simulation.status())},
  });
}

std::string runSummary(const FinishedRun& run) {
  const Simulation& simulation = run.simulation;
  const auto evaluations = static_cast<double>(simulation.forceEvaluations());
  std::string text = sizeAndMethod(simulation) + "\n";
  text += fmt::format("simulated     {:.6g} s in {} steps of at most {:.6g} s, {} force evaluations\n",
                      simulation.time(), simulation.steps(), simulation.largestStep(), simulation.forceEvaluations());
  text += fmt::format("took          {:.4g} s of stepping", run.seconds);
  if (run.seconds > 0 && evaluations > 0) {
    text += fmt::format(": {:.3g} times real time, {:.3g} ns per particle and force evaluation",
                        simulation.time() / run.seconds, 1e9 * run.seconds / evaluations / simulation.sheet().count());
  }
  return text + fmt::format("\n{}{}\nhash          {}\nstatus        {}\n", energyLines(run), stableStepLine(run),
                            hashText(simulation), nameOf(simulation.status()));
}

std::string runPlan(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  const Method& method = simulation.method();
  std::string text = sizeAndMethod(simulation) + "\n";
  if (!scene.shows.empty()) text += scene.shows + "\n";
  text += "springs (ks in N/m, kd in N s/m): ";
  for (const ForceTerm* term : forceTerms()) {
    const auto number = [&](const Parameter& parameter) { return valueText(parameter, scene); };
    if (term->family) text += fmt::format("{} {}; ", term->name, joined(term->parameters, number));
  }
  text += scene.damping == Damping::Relative ? "relative damping\n" : "axial damping\n";
  text += fmt::format("spacing {:.4g} m, particle mass {:.4g} kg", scene.spacing, scene.particleMass);
  for (const ForceTerm* term : forceTerms()) {
    if (term->family) continue;
    for (const Parameter& parameter : term->parameters) {
      text += fmt::format(", {} {} {}", parameter.label, valueText(parameter, scene), parameter.unit);
    }
  }
  text += "\n";
  const int evaluations = method.evaluationsPerStep;
  text += fmt::format("{}: {}; order {}, {}\n", method.name, method.scheme, method.order,
                      evaluations < 0
                          ? "as many force evaluations a step as it needs"
                          : fmt::format("{} force evaluation{} a step", evaluations, evaluations == 1 ? "" : "s"));
  const std::vector<double> edges = pushEdges(scene);
  for (std::size_t k = 1; k < edges.size(); ++k) {
    text += fmt::format("span {}: {:.6g} s to {:.6g} s\n", k, edges[k - 1], edges[k]);
  }
  for (const std::string& idle : idleTerms(scene)) text += "note: changes nothing visible: " + idle + "\n";
  return text;
}

std::string failureAdvice(const FinishedRun& run) {
  if (wasHalted(run)) return haltAdvice(run.simulation);
  const Simulation& simulation = run.simulation;
  const Scene& scene = simulation.scene();
  const Method& method = simulation.method();
  const double step = simulation.largestStep(), limit = run.stableStep;
  const bool finite = simulation.status() == Status::Unstable;
  const std::string what =
      fmt::format("{} with steps of {:.6g} s {} at t = {:.6g} s. ", method.name, step,
                  finite ? "became unstable (the cloth gained energy by itself)" : "left the range of the numbers",
                  simulation.alarmTime());
  if (method.adaptive && scene.tolerance > 0) return what + toleranceAdvice(simulation, limit);
  if (std::isnan(limit)) {
    return what + fmt::format("No limit is predicted for it. Try --dt {:.2g}.", roundedDown(step / 2));
  }
  if (roundingDecides(scene, step, limit)) return what + roundingAdvice(limit);
  const StepLimit said = stepLimit(scene, method);
  return what +
         (limit >= step ? deformedAdvice(limit, said.certified, step) : limitAdvice(simulation, said, limit, step));
}

}  // namespace tyg

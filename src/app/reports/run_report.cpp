// Reports of a run.
#include "app/reports/run_report.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "app/reports/json.h"
#include "study/diet/idle_terms.h"
#include "study/limits/stability.h"
#include "tyg/methods.h"
#include "util/text.h"
#include "viewer/cure.h"

namespace tyg {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::string name(const Method& method) { return std::string(method.name); }

std::string stableStepLine(const FinishedRun& run) {
  if (std::isnan(run.stableStep)) return "stable step   no limit";
  if (run.stableStep == 0) return "stable step   none: this method needs damping of every wave to hold";
  const double share = run.simulation.largestStep() / run.stableStep;
  const std::string used = share < 2 ? formatted("%.3g %% of that", 100 * share) : formatted("%.0f times that", share);
  return formatted("stable step   up to %.4g s is predicted for the sheet at rest; this run used ", run.stableStep) +
         used;
}

/// The moments inside the run at which a scene's push begins or ends.
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
  if (simulation.method().adaptive) return formatted("a tolerance of %.6g m", simulation.scene().tolerance);
  return formatted("a step of %.6g s", simulation.dt());
}

std::string sizeAndMethod(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  return scene.title + formatted(": %d x %d particles, %s with %s, %s, %d thread%s", scene.columns, scene.rows,
                                 name(simulation.method()).c_str(), accuracyAsked(simulation).c_str(),
                                 nameOf(scene.precision), simulation.threads(), simulation.threads() == 1 ? "" : "s");
}

/// Energies and stretch, where they still say something: those of a run that has blown up are digits without meaning.
std::string energyLines(const FinishedRun& run) {
  const Ledger& now = run.ledger;
  constexpr double kMostMeaning = 9;  // of stretch: ten times its length
  const bool cloth = now.maxStretch <= kMostMeaning && std::isfinite(now.kinetic + now.elastic + now.gravitational);
  if (run.simulation.status() != Status::Ok && !cloth) {
    return "energy        past meaning: the cloth has flown apart (--json gives the numbers)\n";
  }
  std::string text =
      formatted("energy        kinetic %.4g J, elastic %.4g J, gravitational %.4g J, work of pushes %.4g J\n",
                now.kinetic, now.elastic, now.gravitational, now.work);
  if (run.followsLoss) {
    text += formatted("ledger        dissipated %.4g J; drift %.3g of the run's energy scale of %.4g J\n",
                      now.dissipated, now.drift, now.scale);
  }
  return text + formatted("stretch       springs up to %.3g %% longer than at rest (looked at every 64 steps)\n",
                          100 * now.maxStretch);
}

std::string firstToFail(const Scene& scene, const StepLimit& limit) {
  return "the motion that fails first: " + describe(scene, limit);
}

/// A tolerance lets waves tremble by as much: a thousandth of the spacing is a tremble that no alarm sees.
std::string toleranceAdvice(const Simulation& simulation, double limit) {
  const Scene& scene = simulation.scene();
  const std::string fixed =
      limit > 0
          ? formatted("Steps of %.4g s would hold at rest, and a tolerance of %.2g m is too loose to keep to them; ",
                      limit, scene.tolerance) +
                firstToFail(scene, stepLimit(scene, simulation.method(), true)) + ". "
          : "";
  return fixed + formatted("Try --tolerance %.2g.", std::min(scene.tolerance / 10, 1e-3 * scene.spacing));
}

/// Where an adaptive method's steps left the numbers whole, they became too short.
bool cameToAStand(const FinishedRun& run) {
  const Simulation& simulation = run.simulation;
  return simulation.method().adaptive && simulation.scene().tolerance > 0 && simulation.status() == Status::NotFinite &&
         std::isfinite(run.ledger.kinetic + run.ledger.elastic);
}

std::string standAdvice(const Simulation& simulation) {
  return formatted(
      "%s came to a stand at t = %.6g s: the steps that keep its tolerance of %.6g m became so short that "
      "the run would not end. Try a larger --tolerance%s.",
      name(simulation.method()).c_str(), simulation.alarmTime(), simulation.scene().tolerance,
      simulation.scene().precision == Precision::Float ? ", or --precision double" : "");
}

/// No deformation allows so much less than the limit at rest.
bool roundingDecides(const Scene& scene, double step, double limit) {
  constexpr double kFarBelow = 1e-3;
  return scene.precision == Precision::Float && std::isfinite(limit) && step < kFarBelow * limit;
}

std::string roundingAdvice(double limit) {
  return formatted(
      "The predicted limit at rest is %.4g s: so far below it a step moves a particle by little more than the rounding "
      "of float. Try --precision double, or --dt %.2g.",
      limit, roundedDown(0.1 * limit));
}

}  // namespace

std::string runJson(const FinishedRun& run) {
  const Simulation& simulation = run.simulation;
  const Scene& scene = simulation.scene();
  JsonObject json;
  json.add("scene", scene.name);
  json.add("columns", scene.columns);
  json.add("rows", scene.rows);
  json.add("integrator", simulation.method().name);
  json.add("precision", nameOf(scene.precision));
  json.add("threads", simulation.threads());
  json.add("dt_asked", simulation.dt());
  json.add("dt", simulation.largestStep());
  json.add("steps", simulation.steps());
  json.add("force_evaluations", simulation.forceEvaluations());
  json.add("seconds", run.seconds);
  json.add("simulated_seconds", simulation.time());
  json.add("kinetic_J", run.ledger.kinetic);
  json.add("elastic_J", run.ledger.elastic);
  json.add("gravitational_J", run.ledger.gravitational);
  json.add("work_J", run.ledger.work);
  json.add("dissipated_J", run.followsLoss ? run.ledger.dissipated : kUnknown);
  json.add("ledger_drift", run.followsLoss ? run.ledger.drift : kUnknown);
  json.add("max_stretch", run.ledger.maxStretch);
  json.add("stable_dt", run.stableStep);
  json.add("hash", hashText(simulation));
  json.add("status", nameOf(simulation.status()));
  return json.text();
}

std::string runSummary(const FinishedRun& run) {
  const Simulation& simulation = run.simulation;
  const auto evaluations = static_cast<double>(simulation.forceEvaluations());
  std::string text = sizeAndMethod(simulation) + "\n";
  text += formatted("simulated     %.6g s in %lld steps of at most %.6g s, %lld force evaluations\n", simulation.time(),
                    static_cast<long long>(simulation.steps()), simulation.largestStep(),
                    static_cast<long long>(simulation.forceEvaluations()));
  text += formatted("took          %.4g s of stepping", run.seconds);
  if (run.seconds > 0 && evaluations > 0) {
    text += formatted(": %.3g times real time, %.3g ns per particle and force evaluation",
                      simulation.time() / run.seconds, 1e9 * run.seconds / evaluations / simulation.sheet().count());
  }
  text += "\n" + energyLines(run);
  text += stableStepLine(run) + "\n";
  text += "hash          " + hashText(simulation) + "\n";
  text += "status        " + std::string(nameOf(simulation.status())) + "\n";
  return text;
}

std::string runPlan(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  const Method& method = simulation.method();
  std::string text = sizeAndMethod(simulation) + "\n";
  if (!scene.shows.empty()) text += scene.shows + "\n";
  text += formatted(
      "springs (ks in N/m, kd in N s/m): structural %.4g, %.4g; shear %.4g, %.4g; bend %.4g, %.4g; %s damping\n",
      scene.structural.ks, scene.structural.kd, scene.shear.ks, scene.shear.kd, scene.bend.ks, scene.bend.kd,
      scene.damping == Damping::Relative ? "relative" : "axial");
  text += formatted("spacing %.4g m, particle mass %.4g kg, gravity (%.4g, %.4g, %.4g) m/s2, drag %.4g N s/m\n",
                    scene.spacing, scene.particleMass, scene.gravity.x, scene.gravity.y, scene.gravity.z, scene.drag);
  const std::string evaluations = method.evaluationsPerStep < 0
                                      ? "as many force evaluations a step as it needs"
                                      : formatted("%d force evaluation%s a step", method.evaluationsPerStep,
                                                  method.evaluationsPerStep == 1 ? "" : "s");
  text += formatted("%s: %s; order %d, %s\n", name(method).c_str(), std::string(method.scheme).c_str(), method.order,
                    evaluations.c_str());
  const std::vector<double> edges = pushEdges(scene);
  for (std::size_t k = 1; k < edges.size(); ++k) {
    text += formatted("span %zu: %.6g s to %.6g s\n", k, edges[k - 1], edges[k]);
  }
  for (const std::string& idle : idleTerms(scene)) text += "note: changes nothing visible: " + idle + "\n";
  return text;
}

std::string failureAdvice(const FinishedRun& run) {
  const Simulation& simulation = run.simulation;
  const Method& method = simulation.method();
  const double step = simulation.largestStep(), limit = run.stableStep;
  const bool finite = simulation.status() == Status::Unstable;
  const std::string what =
      formatted("%s with steps of %.6g s %s at t = %.6g s. ", name(method).c_str(), step,
                finite ? "became unstable (the cloth gained energy by itself)" : "left the range of the numbers",
                simulation.alarmTime());
  if (cameToAStand(run)) return standAdvice(simulation);
  if (method.adaptive && simulation.scene().tolerance > 0) return what + toleranceAdvice(simulation, limit);
  if (std::isnan(limit)) return what + formatted("No limit is predicted for it. Try --dt %.2g.", roundedDown(step / 2));
  if (roundingDecides(simulation.scene(), step, limit)) return what + roundingAdvice(limit);
  const StepLimit said = stepLimit(simulation.scene(), method, true);
  if (limit >= step) {
    const bool certified = said.certified > 0 && said.certified < step;
    return what +
           formatted(
               "The predicted limit of the sheet at rest, %.4g s, was kept, but a cloth far from rest allows less. ",
               limit) +
           (certified ? formatted("Try --dt %.2g, which holds in any deformation.", roundedDown(said.certified))
                      : formatted("Try --dt %.2g.", roundedDown(step / 2)));
  }
  const Method* other = methodThatHolds(simulation.scene(), method, step);
  const std::string advice =
      other == nullptr ? "" : "--integrator " + name(*other) + ", predicted to hold with this step";
  if (limit == 0) {
    return what + "No step is predicted to be stable for it here: it holds only where damping is strong enough; " +
           firstToFail(simulation.scene(), said) + ". Try " +
           (advice.empty() ? "another method with a smaller step" : advice) + ".";
  }
  return what + formatted("The predicted limit at rest is %.4g s; ", limit) + firstToFail(simulation.scene(), said) +
         formatted(". Try --dt %.2g", roundedDown(0.9 * limit)) + (advice.empty() ? "" : ", or " + advice) + ".";
}

}  // namespace tyg

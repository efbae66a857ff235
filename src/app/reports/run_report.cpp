// Summaries of runs that ended, plans of those to come.
#include "app/reports/run_report.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "app/reports/json.h"
#include "core/forces/term.h"
#include "core/forces/terms/contact.h"
#include "core/forces/terms/springs.h"
#include "core/scene/bodies.h"
#include "core/simulation/timetable.h"
#include "study/diet/idle_terms.h"
#include "study/limits/fast_contact.h"
#include "util/text.h"
#include "util/visible_text.h"

namespace tyg {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::string stableStepLine(const FinishedRun& run) {
  if (std::isnan(run.stableStep)) return "stable step   no limit";
  if (run.stableStep == 0) return "stable step   none: this method holds only where every wave is damped";
  if (run.simulation.steps() == 0) {
    return fmt::format("stable step   up to {:.4g} s is predicted for the sheet at rest", run.stableStep);
  }
  const double share = run.simulation.largestStep() / run.stableStep;
  return fmt::format(
      "stable step   up to {:.4g} s is predicted for the sheet at rest; this run used {}", run.stableStep,
      share < 2 ? fmt::format("{:.3g} % of that", 100 * share) : fmt::format("{:.0f} times that", share));
}

std::string vectorText(const Vec3& v) { return fmt::format("({:.4g}, {:.4g}, {:.4g})", v.x, v.y, v.z); }

std::string valueText(const Parameter& parameter, const Scene& scene) {
  const Vec3 value = parameter.get(scene);
  return parameter.count == 1 ? fmt::format("{:.4g}", value.x) : vectorText(value);
}

/// The run from one begin or end of a push, a wind or a motion to the next.
std::string spansText(const Scene& scene) {
  std::vector<double> edges = edgesWithin(scene);
  edges.insert(edges.begin(), 0);
  edges.push_back(scene.duration);
  std::string text;
  for (std::size_t k = 1; k < edges.size(); ++k) {
    text += fmt::format("span {}: {:.6g} s to {:.6g} s\n", k, edges[k - 1], edges[k]);
  }
  return text;
}

/// What is touched.
std::string bodiesText(const Scene& scene) {
  if (!hasTerm(scene, ContactTerm::kTerm)) return "";
  std::string text;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const Body& body = scene.bodies[k];
    text += fmt::format("body {}: {}{} at {} m", k + 1, nameOf(body.shape),
                        body.name.empty() || body.name == nameOf(body.shape) ? "" : " " + oneLine(body.name),
                        vectorText(body.at));
    if (body.shape == Shape::Plane) text += ", normal " + vectorText(body.normal);
    if (body.shape == Shape::Capsule) text += ", axis " + vectorText(body.axis) + " m";
    if (body.shape == Shape::Box) text += ", half " + vectorText(body.half) + " m, rounding";
    if (body.shape == Shape::Ball || body.shape == Shape::Capsule) text += ", radius";
    if (body.shape != Shape::Plane) text += fmt::format(" {:.4g} m", body.radius);
    text += fmt::format(", gap {:.4g} m\n", gapOf(scene, body));
  }
  return text;
}

std::string placeText(const Place& place) {
  return place.name.empty() ? fmt::format("[{}, {}]", place.column, place.row) : place.name;
}

/// Winds, motions, cuts and tears, where there are any; the first wind is among the parameters.
std::string actionsText(const Scene& scene) {
  std::string text;
  if (scene.winds.size() > 1) text += fmt::format("{} winds, of which the first is named above\n", scene.winds.size());
  for (std::size_t k = 0; k < scene.moves.size(); ++k) {
    const Move& move = scene.moves[k];
    text += fmt::format("move {}: {}{} m/s from {:.6g} s to {:.6g} s\n", k + 1,
                        (move.body.empty() ? joined(move.what, placeText) : oneLine(move.body)) + " with ",
                        vectorText(move.velocity), move.at, move.at + move.duration);
  }
  for (std::size_t k = 0; k < scene.cuts.size(); ++k) {
    const auto& [line, at] = scene.cuts[k];
    text += fmt::format("cut {}: from [{:.6g}, {:.6g}] to [{:.6g}, {:.6g}] at {:.6g} s\n", k + 1, line.fromColumn,
                        line.fromRow, line.toColumn, line.toRow, at);
  }
  if (const double most = strainThatTears(scene); std::isfinite(most)) {
    text += fmt::format("tears at {:.4g} J/m: a structural spring breaks where it is {:.4g} % longer than at rest\n",
                        scene.tear.toughness, 100 * most);
  }
  return text;
}

std::string accuracyAsked(const Simulation& simulation) {
  if (simulation.method().adaptive) return fmt::format("a tolerance of {:.6g} m", simulation.scene().tolerance);
  return fmt::format("a step of {:.6g} s", simulation.dt());
}

std::string sizeAndMethod(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  return fmt::format("{}: {} x {} particles, {} with {}, {}, {} thread{}", oneLine(scene.title), scene.columns,
                     scene.rows, simulation.method().name, accuracyAsked(simulation), nameOf(scene.precision),
                     simulation.threads(), simulation.threads() == 1 ? "" : "s");
}

/// What the method itself gained or lost, J: what neither forces nor damping account for.
std::string byMethod(const Ledger& now, double gained) {
  if (!(now.scale > 0)) return "no energy is there to compare a drift with";
  return fmt::format("the method itself {} {:.4g} J, a drift of {:.3g} of the run's energy scale of {:.4g} J",
                     gained < 0 ? "lost" : "gained", std::abs(gained), gained / now.scale, now.scale);
}

/// A step moves the cloth by little more than the last place of its coordinates, and yet a run of such steps would move
/// it far: particles then stand, or move by whole units of rounding.
std::string roundingRemark(const FinishedRun& run) {
  constexpr double kFewUnits = 4, kFar = 1000;
  const Simulation& simulation = run.simulation;
  const bool isFloat = simulation.scene().precision == Precision::Float;
  const double unit = isFloat ? std::numeric_limits<float>::epsilon() : std::numeric_limits<double>::epsilon();
  const double rounding = unit * simulation.sheet().size();
  const double speed =
      std::sqrt(2 * run.ledger.kinetic / (simulation.sheet().count() * simulation.sheet().particleMass));
  const bool stands = speed * simulation.largestStep() < kFewUnits * rounding;
  if (!stands || !(speed * simulation.time() > kFar * rounding)) return "";
  return fmt::format(
      "remark        a step of {:.4g} s moves particles by no more than the rounding of {}: they stand, or move by "
      "rounding alone. {}\n",
      simulation.largestStep(), nameOf(simulation.scene().precision),
      isFloat ? "Take longer steps, or --precision double." : "Take longer steps.");
}

std::string contactRemark(const FinishedRun& run) {
  if (run.simulation.status() != Status::Ok) return "";
  const std::string note = fastContactNote(run.simulation);
  return note.empty() ? "" : "remark        " + note + "\n";
}

/// Energies and stretch, where they still say something: those of a run that has blown up are digits without meaning.
std::string energyLines(const FinishedRun& run) {
  const Ledger& now = run.ledger;
  constexpr double kMostMeaning = 9;  // of stretch: ten times its length
  const bool cloth = now.maxStretch <= kMostMeaning && std::isfinite(now.mechanical());
  if (run.simulation.status() != Status::Ok && !cloth) {
    return "energy        without meaning: the cloth has flown apart (--json gives the numbers)\n";
  }
  std::string text = fmt::format("energy        kinetic {:.4g} J", now.kinetic);
  for (const auto& [name, joules] : now.stored) text += fmt::format(", {} {:.4g} J", name, joules);
  for (const auto& [name, joules] : now.work) {
    const bool isEstimated = name == "wind" && !run.followsLoss;  // from its power at the energy checks
    text += fmt::format(", work of {} {}{:.4g} J", name, isEstimated ? "about " : "", joules);
  }
  text += "\n";
  if (run.followsLoss)
    text += fmt::format("ledger        damping and drag dissipated {:.4g} J; {}\n", now.dissipated,
                        byMethod(now, now.drift * now.scale));
  const double gained = now.mechanical() - now.work.sum() - run.startEnergy;
  constexpr double kWorthTelling = 0.01;  // of the scale
  if (!run.followsLoss && !isDamped(run.simulation.scene()) && std::abs(gained) > kWorthTelling * now.scale) {
    text += fmt::format("losses        nothing here damps; {}\n", byMethod(now, gained));
  }
  return text +
         fmt::format("stretch       springs up to {:.3g} % longer than at rest (seen every 64 steps, not between)\n",
                     100 * now.maxStretch);
}

/// Springs that cuts and tears have taken, of the families that the scene has.
int brokenSprings(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  const Sheet& sheet = simulation.sheet();
  constexpr std::pair<Family, Missing::Bit> kBits[]{
      {Family::Structural, Missing::Right}, {Family::Structural, Missing::Down}, {Family::Shear, Missing::DownRight},
      {Family::Shear, Missing::DownLeft},   {Family::Bend, Missing::Right2},     {Family::Bend, Missing::Down2},
  };
  int count = 0;
  for (const auto& [family, bit] : kBits) {
    for (int particle = 0; particle < sheet.count() && familyOf(scene, family).present(); ++particle) {
      count += sheet.missing.has(particle, bit) ? 1 : 0;
    }
  }
  return count;
}

}  // namespace

std::string runJson(const FinishedRun& run) {
  const Simulation& simulation = run.simulation;
  const Scene& scene = simulation.scene();
  Json json({
      {"scene", scene.name},
      {"columns", scene.columns},
      {"rows", scene.rows},
      {"integrator", simulation.method().name},
      {"precision", nameOf(scene.precision)},
      {"threads", simulation.threads()},
      {"device", run.device.device},
      {"device_name", run.device.name},
      {"same_bits", run.device.sameBits},
      {"stray_m", run.device.strays},
      {"dt_asked", simulation.dt()},
      {"dt", simulation.largestStep()},
      {"steps", simulation.steps()},
      {"force_evaluations", simulation.forceEvaluations()},
      {"seconds", run.seconds},
      {"simulated_seconds", simulation.time()},
      {"kinetic_J", run.ledger.kinetic},
  });
  for (const auto& [name, joules] : run.ledger.stored) json.update({{fmt::format("{}_J", name), joules}});
  json.update({{"work_J", run.ledger.work.sum()}});
  for (const auto& [name, joules] : run.ledger.work) {
    if (name != "pushes") json.update({{fmt::format("work_of_{}_J", name), joules}});
  }
  if (!scene.bodies.empty()) {
    const bool choosesSteps = simulation.method().adaptive && scene.tolerance > 0;
    json.update({{"largest_speed_m_per_s", simulation.largestSpeed()},
                 {"layers_per_step", choosesSteps ? kUnknown : layersPerStep(simulation)}});
  }
  json.update({
      {"dissipated_J", run.followsLoss ? run.ledger.dissipated : kUnknown},
      {"ledger_drift", run.followsLoss && run.ledger.scale > 0 ? run.ledger.drift : kUnknown},
      {"max_stretch", run.ledger.maxStretch},
      {"broken_springs", brokenSprings(simulation)},
      {"stable_dt", run.stableStep},
      {"hash", hashText(simulation)},
      {"status", nameOf(simulation.status())},
  });
  return jsonText(json);
}

std::string runSummary(const FinishedRun& run) {
  const Simulation& simulation = run.simulation;
  const auto evaluations = static_cast<double>(simulation.forceEvaluations());
  std::string text = sizeAndMethod(simulation) + "\n";
  text += fmt::format("simulated     {:.6g} s in {} step{} of at most {:.6g} s, {} force evaluations\n",
                      simulation.time(), simulation.steps(), simulation.steps() == 1 ? "" : "s",
                      simulation.largestStep(), simulation.forceEvaluations());
  text += fmt::format("took          {:.4g} s of stepping", run.seconds);
  if (run.seconds > 0 && evaluations > 0) {
    text += fmt::format(": {:.3g} times real time, {:.3g} ns per particle and force evaluation",
                        simulation.time() / run.seconds, 1e9 * run.seconds / evaluations / simulation.sheet().count());
  }
  const std::string device = sentenceOn(run.device);
  if (!device.empty()) text += "\ndevice        " + device;
  const int broken = brokenSprings(simulation);
  if (broken > 0) text += fmt::format("\nbroken        {} spring{}, cut or torn", broken, broken == 1 ? "" : "s");
  return text + fmt::format("\n{}{}\n{}{}hash          {}\nstatus        {}\n", energyLines(run), stableStepLine(run),
                            contactRemark(run), roundingRemark(run), hashText(simulation), nameOf(simulation.status()));
}

std::string runPlan(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  const Method& method = simulation.method();
  std::string text = sizeAndMethod(simulation) + "\n";
  if (!scene.shows.empty()) text += oneLine(scene.shows) + "\n";
  text += "springs (ks in N/m, kd in N s/m): ";
  for (const ForceTerm* term : forceTerms()) {
    const auto number = [&](const Parameter& parameter) { return valueText(parameter, scene); };
    if (term->family) text += fmt::format("{} {}; ", term->name, joined(term->parameters, number));
  }
  text += scene.damping == Damping::Relative ? "relative damping\n" : "axial damping\n";
  text += fmt::format("spacing {:.4g} m, particle mass {:.4g} kg", scene.spacing, scene.particleMass);
  for (const ForceTerm* term : forceTerms()) {
    if (term->family || !hasTerm(scene, *term)) continue;
    const bool isContact = term == &ContactTerm::kTerm;  // its bodies have lines of their own
    for (const Parameter& parameter : term->parameters) {
      if (parameter.ofList && parameter.get(scene) == Vec3{}) continue;  // still air has no wind, a wind need not gust
      if (isContact && (parameter.ofList || (parameter.acts != nullptr && !parameter.acts(scene)))) continue;
      text += fmt::format(", {} {}", parameter.label, valueText(parameter, scene));
      if (parameter.unit != "1") text += fmt::format(" {}", parameter.unit);
    }
  }
  text += "\n";
  const int evaluations = method.evaluationsPerStep;
  text += fmt::format("{}: {}; order {}, {}\n", method.name, method.scheme, method.order,
                      evaluations < 0
                          ? "as many force evaluations a step as it needs"
                          : fmt::format("{} force evaluation{} a step", evaluations, evaluations == 1 ? "" : "s"));
  text += bodiesText(scene) + actionsText(scene) + spansText(scene);
  for (const std::string& idle : idleTerms(scene)) text += "note: changes nothing visible: " + idle + "\n";
  return text;
}

}  // namespace tyg

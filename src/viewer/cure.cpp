// Builds the sentences, and tries the methods in the order of their table against their limits at rest.
#include "viewer/cure.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/scene/bodies.h"
#include "study/limits/measured_limit.h"
#include "study/limits/stability.h"
#include "tyg/methods.h"
#include "util/amounts.h"

namespace tyg {
namespace {

constexpr double kSafeShare = 0.9;  // of the limit

std::string name(const Method& method) { return std::string(method.name); }

bool chooses(const Simulation& simulation) { return simulation.method().adaptive && simulation.scene().tolerance > 0; }

std::string whatBroke(const Simulation& simulation, double alarmTime) {
  const std::string with = chooses(simulation)
                               ? fmt::format("a tolerance of {:.4g} mm", 1e3 * simulation.scene().tolerance)
                               : fmt::format("a step of {:.4g} ms", 1e3 * simulation.dt());
  const bool finite = simulation.status() == Status::Unstable;
  return name(simulation.method()) + " with " + with +
         (finite ? " became unstable" : " left the numbers that can be computed with") +
         fmt::format(" at {:.3f} s", alarmTime);
}

std::string cause(const Simulation& simulation, double limit) {
  if (chooses(simulation) || !std::isfinite(limit)) return "";
  if (limit == 0) return ": no step holds with so little damping";
  if (limit <= simulation.dt()) {
    const StepLimit said = stepLimit(simulation.scene(), simulation.method());
    constexpr double kSame = 0.99;
    const bool byContact = said.byContact && limit > kSame * said.predicted;
    return fmt::format(": its limit is {:.3g} ms", 1e3 * limit) +
           (byContact ? fmt::format(", set by contact with {}, not the springs", bodiesInWords(simulation.scene()))
                      : "");
  }
  return fmt::format(": it kept its limit of {:.3g} ms, but this cloth is far from rest", 1e3 * limit);
}

std::string waysOut(const Simulation& simulation, const Cure& cure) {
  const std::string other = cure.method != nullptr ? name(*cure.method) : "";
  const std::string holds = other.empty() ? "" : other + ", which holds with this step";
  if (cure.step > 0) {
    return fmt::format("; take a step of {:.3g} ms", 1e3 * cure.step) + (holds.empty() ? "" : ", or " + holds) + ".";
  }
  if (!holds.empty()) return "; take " + holds + ".";
  return chooses(simulation) ? "; take a smaller tolerance." : ".";
}

/// s: half of the step that broke, half of that, and so on, until the scene's own motion holds with it. A trial takes a
/// tenth of a second at most; where that is not enough to tell, half the step is the next best guess.
double smallerStep(const Simulation& simulation) {
  constexpr int kHalvings = 6;
  constexpr double kShortTrial = 3e6, kSolve = 10;  // particles times force evaluations
  const Method& method = simulation.method();
  MeasurePlan plan;
  plan.mostWork = method.solves ? kShortTrial / kSolve : kShortTrial;
  Scene scene = simulation.scene();
  for (int k = 1; k <= kHalvings; ++k) {
    scene.dt = roundedDown(std::ldexp(simulation.dt(), -k));
    if (survives(scene, method, plan).value_or(true)) return scene.dt;
  }
  return roundedDown(simulation.dt() / 2);
}

}  // namespace

const Method* methodThatHolds(const Scene& scene, const Method& failed, double step, double share) {
  for (const Method& method : methods()) {
    const double limit = share * restLatticeLimit(scene, method);
    const bool choosesItsSteps = method.adaptive && scene.tolerance > 0;
    if (method.name == failed.name || choosesItsSteps || limit < 1.05 * step || !takes(method, scene)) continue;
    return &method;
  }
  return nullptr;
}

double safeStep(double limit) { return !std::isfinite(limit) || limit <= 0 ? 0 : roundedDown(kSafeShare * limit); }

std::string takeStepThatHolds(Scene& scene) {
  const Method& method = findMethod(scene.integrator);
  if (method.adaptive && scene.tolerance > 0) return {};
  const double safe = safeStep(restLatticeLimit(scene, method));
  if (!(safe > 0) || scene.dt * kSafeShare <= safe) return {};
  const double before = std::exchange(scene.dt, safe);
  return fmt::format("{} x {} particles are stable with smaller steps only: {:.3g} ms instead of {:.3g} ms",
                     scene.columns, scene.rows, 1e3 * safe, 1e3 * before);
}

Cure findCure(const Simulation& simulation, double limit) {
  Cure cure;
  const double step = simulation.dt();
  const double rest = restLatticeLimit(simulation.scene(), simulation.method());
  // A cloth that broke below its limit at rest is so stretched that other methods' limits at rest say too much as well.
  const double share = rest > step && !chooses(simulation) ? std::min(limit, step) / rest : 1;
  cure.method = methodThatHolds(simulation.scene(), simulation.method(), step, share);
  if (chooses(simulation) || limit == 0) return cure;
  // A limit that was kept and broke all the same says too much.
  cure.step = limit <= step ? safeStep(limit) : smallerStep(simulation);
  return cure;
}

std::string describeFailure(const Simulation& simulation, double alarmTime, double limit, const Cure& cure) {
  return whatBroke(simulation, alarmTime) + cause(simulation, limit) + waysOut(simulation, cure);
}

std::string describeStall(const Simulation& simulation, double seconds, const Cure& cure) {
  const std::string holds =
      cure.method != nullptr ? "; take " + name(*cure.method) + ", which holds with this step." : ".";
  return fmt::format(
      "{} stalled at {:.3f} s: in {:.3g} s of computing, the steps that its tolerance of {:.4g} mm asks for "
      "did not reach the end of an output interval of {:.4g} ms{}",
      simulation.method().name, simulation.time(), seconds, 1e3 * simulation.scene().tolerance, 1e3 * simulation.dt(),
      holds);
}

}  // namespace tyg

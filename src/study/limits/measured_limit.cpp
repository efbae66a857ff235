// Every step is tried by a run of its own: first outward from where the limit is expected, until one step has held and
// one has failed, then by halving what lies between them.
#include "study/limits/measured_limit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/forces/term.h"
#include "core/scene/bodies.h"
#include "study/limits/stability.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"
#include "util/noise.h"

namespace tyg {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// Of a resting particle, in layers.
constexpr double kDepth = 100;

enum class Outcome { Held, Failed, Unknown };

/// Runs the scene with steps of `step` s. Unknown: it would take too much work, or the observer said stop.
Outcome tried(double step, const Scene& scene, const Method& method, const MeasurePlan& plan) {
  const double steps = plan.steps > 0 ? double(plan.steps) : std::ceil(scene.duration / step);
  Scene timed = scene;
  timed.tolerance = 0;  // adaptive methods take the step they are given
  timed.dt = step;
  timed.duration = steps * step;
  const std::optional<bool> held = survives(timed, method, plan);
  return !held ? Outcome::Unknown : *held ? Outcome::Held : Outcome::Failed;
}

/// From where it is predicted, or where nothing is stable from a step that certainly fails.
double measuredFromPrediction(const Scene& scene, const Method& method, MeasurePlan plan) {
  const double predicted = restLatticeLimit(scene, method);
  plan.begin = predicted > 0 ? predicted : restLatticeLimit(scene, findMethod("symplectic-euler"));
  return measuredLimit(scene, method, plan);
}

}  // namespace

Scene linearRegime(Scene scene) {
  scene = withoutSteadyForce(withoutBodies(std::move(scene)));
  scene.winds.clear();
  scene.moves.clear();
  scene.pushes.clear();
  scene.displacements.clear();
  scene.precision = Precision::Double;
  std::uint32_t seed = 1;
  const auto some = [&] { return 1e-4 * scene.spacing * noise(seed); };
  const Sheet sheet = makeSheet(scene);
  for (int particle = 0; particle < sheet.count(); ++particle) {
    const double x = some(), y = some(), z = some();
    scene.displacements.push_back({{"", particle % scene.columns, particle / scene.columns}, {x, y, z}});
  }
  return scene;
}

Scene restingParticle(Scene scene) {
  constexpr double kTiny = 1e-4;                      // layers
  constexpr double kFriction = 1e6, kSlowest = 1e-7;  // of the weight, along the plane
  Contact contact = scene.contact;
  contact.gap = 0;
  if (contact.friction > 0) contact.friction = kFriction;
  for (const ForceTerm* term : forceTerms()) {
    if (term->family) leaveOut(scene, *term);
  }
  scene.columns = scene.rows = 1;
  scene.pins.clear();
  scene = linearRegime(std::move(scene));
  // So deep the push is k l (u - 1/2), u the depth in layers.
  const double push = contact.stiffness * contact.layer * (kDepth - 0.5);
  const double weight = push / scene.particleMass;
  scene.gravity = {contact.friction > 0 ? kSlowest * weight : 0, -weight, 0};
  const double tiny = kTiny * contact.layer;
  scene.displacements = {{{"", 0, 0}, {0, tiny, 0}}};
  scene.contact = contact;
  scene.bodies = {{.shape = Shape::Plane, .at = {0, kDepth * contact.layer, 0}}};
  return scene;
}

bool isResting(const Simulation& particle) {
  return std::abs(particle.position(0).y) < kDepth / 2 * particle.scene().contact.layer;
}

std::optional<bool> survives(const Scene& scene, const Method& method, const MeasurePlan& plan) {
  constexpr int kManyStages = 20;  // of a method that takes as many as it needs
  const int evaluations = method.evaluationsPerStep < 0 ? kManyStages : method.evaluationsPerStep + 1;
  const double particles = double(scene.columns) * scene.rows;
  const bool choosesSteps = method.adaptive && scene.tolerance > 0;
  if (!choosesSteps && scene.duration / scene.dt * evaluations * particles > plan.mostWork) return {};
  Simulation simulation(scene, method, {.threads = plan.threads});
  bool stopped = false, gone = false;
  const auto isGone = [&] { return plan.holds && !plan.holds(simulation); };
  simulation.observe([&] {
    gone = gone || isGone();
    stopped = stopped || (choosesSteps && double(simulation.forceEvaluations()) * particles > plan.mostWork);
    stopped = stopped || (plan.observer && !plan.observer());
    return !stopped && !gone;
  });
  simulation.advanceTo(scene.duration);
  if (stopped) return {};
  return simulation.status() == Status::Ok && !gone && !isGone();
}

double measuredLimit(const Scene& scene, const Method& method, const MeasurePlan& plan) {
  if (!(plan.begin > 0) || !std::isfinite(plan.begin)) return kUnknown;
  constexpr int kMostTries = 100;  // a dozen are usual
  int tries = 0;
  double held = 0, failed = 0;
  Outcome outcome = Outcome::Unknown;
  const auto attempt = [&](double step) {
    outcome = ++tries > kMostTries ? Outcome::Unknown : tried(step, scene, method, plan);
    (outcome == Outcome::Held ? held : failed) = step;
  };
  attempt(plan.begin);
  // Outward in growing strides from what is expected, downward or upward.
  for (double factor = 1.02; outcome != Outcome::Unknown && (held == 0 || failed == 0);
       factor = std::min(factor * factor, 2.0)) {
    const double step = held > 0 ? held * factor : failed / factor;
    if (step > 8 * plan.begin) return std::numeric_limits<double>::infinity();
    if (step < 1e-6 * plan.begin) return kUnknown;
    attempt(step);
  }
  while (outcome != Outcome::Unknown && failed > (1 + plan.resolution) * held) attempt((held + failed) / 2);
  return outcome == Outcome::Unknown ? kUnknown : held;
}

double measuredAtRest(const Scene& scene, const Method& method, const MeasurePlan& plan) {
  const double ofSheet = measuredFromPrediction(linearRegime(scene), method, plan);
  if (holdingTerm(scene).term == nullptr) return ofSheet;
  const bool byContact = stepLimit(scene, method).byContact;
  if (!byContact && std::isnan(ofSheet)) return ofSheet;
  MeasurePlan ofParticle = plan;
  ofParticle.holds = isResting;
  return std::fmin(ofSheet, measuredFromPrediction(restingParticle(scene), method, ofParticle));
}

}  // namespace tyg

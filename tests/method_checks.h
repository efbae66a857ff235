// What every method is held to, as questions with a number or a yes for an answer: the tests of all methods ask them,
// and a test of methods that are wrong on purpose asks them too, so that each question is known to find something.
#pragma once

#include <cmath>

#include "test_systems.h"
#include "tyg/simulation.h"

namespace tyg::test {

/// Steps in one second at which a method of this order shows its leading error and not yet rounding.
inline int stepsFor(int order) { return order == 1 ? 2048 : order == 2 ? 512 : 96; }

/// The order of convergence that shows in a second of a shaken sheet's motion, against an independent reference: the
/// oracle's forces and a Runge-Kutta method of the tests' own.
inline double observedOrder(const Scene& scene, const Method& method) {
  constexpr double kSeconds = 1;
  constexpr int kReferenceSteps = 4096;  // its error, (10/s * h)^4 / 120, is then near 1e-13 m
  // Shaken, so that no symmetry hides a term.
  Bench<double> start(scene);
  Numbers numbers(21);
  shake(start, 0.2, numbers);
  Points from = start.points();
  for (const int pin : start.sheet.pins) {
    from.x[std::size_t(pin)] = start.sheet.startPosition(pin);
    from.v[std::size_t(pin)] = {};
  }
  Points reference = from;
  Oracle(scene).advance(reference, kSeconds, kReferenceSteps);
  const auto errorAfter = [&](int steps) {
    Bench<double> bench(scene);
    bench.set(from);
    bench.advance(method, kSeconds, steps);
    return distance(bench.points(), reference);
  };
  const int steps = stepsFor(method.order);
  return std::log2(errorAfter(steps) / errorAfter(2 * steps));
}

/// A sheet without any symmetry.
inline Scene lopsided() {
  Scene scene = softSheet(Damping::Relative);
  scene.columns = 6, scene.rows = 5;
  scene.pins = {{"", 0, 0}, {"", 3, 0}};
  scene.pushes = {{{"", 1, 3}, {2, 1, -3}, 0.1, 0.3}};
  scene.gravity = {0.5, -3, 0.2};
  scene.tolerance = 1e-5;
  return scene;
}

/// The same, left for right.
inline Scene mirrored(Scene scene) {
  const auto mirror = [&](Place& place) { place.column = scene.columns - 1 - place.column; };
  for (Place& pin : scene.pins) mirror(pin);
  for (Push& push : scene.pushes) {
    mirror(push.particle);
    push.force.x = -push.force.x;
  }
  scene.gravity.x = -scene.gravity.x;
  return scene;
}

/// How far a second of the mirrored scene ends from the mirror image of a second of the scene, m, at the worst
/// particle.
inline double mirrorError(const Method& method) {
  const Scene scene = lopsided();
  Simulation left(scene, method), right(mirrored(scene), method);
  left.advanceTo(1);
  right.advanceTo(1);
  double worst = 0;
  for (int i = 0; i < scene.columns * scene.rows; ++i) {
    const int column = i % scene.columns;
    const Vec3 here = left.position(i), there = right.position(i - column + scene.columns - 1 - column);
    worst = std::max(worst, length(here - Vec3{-there.x, there.y, there.z}));
  }
  return worst;
}

/// Whether a running method steps after a push as one does that has just been made, bit for bit.
inline bool stepsAfreshAfterAPush(const Scene& scene, const Method& method) {
  constexpr int kPushed = 7;
  constexpr Vec3 kPush{3, -1, 2};
  Simulation simulation(scene, method);
  simulation.tick(20);
  Bench<double> fresh(scene);
  for (int i = 0; i < fresh.sheet.count(); ++i) {
    fresh.state.position.set(i, simulation.position(i));
    fresh.state.velocity.set(i, simulation.velocity(i));
  }
  fresh.forces.addPush(kPushed, kPush);
  fresh.advance(method, simulation.dt(), 1);
  simulation.push(kPushed, kPush, 1);
  simulation.tick();
  return simulation.hash() == hashOf(fresh.state);
}

/// Change of the energy of an undamped sheet that swings for three seconds, fraction of the run's scale.
inline double undampedDrift(const Method& method) {
  Scene scene = softSheet(Damping::Relative);
  scene.structural.kd = scene.shear.kd = scene.bend.kd = scene.drag = 0;
  scene.dt = 0.004;
  scene.tolerance = 1e-6;
  Simulation simulation(scene, method, {.ledger = true, .keepGoing = true});
  simulation.advanceTo(3);
  return std::abs(simulation.ledger().drift);
}

}  // namespace tyg::test

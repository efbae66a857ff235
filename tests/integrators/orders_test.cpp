// Every method's order of convergence, from both sides, against an independent reference: the oracle's forces and a
// Runge-Kutta method of the tests' own. A new method is tested by being in the table.
#include <gtest/gtest.h>

#include "method_checks.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg::test {
namespace {

constexpr double kSeconds = 1;
constexpr int kReferenceSteps = 4096;    // its error, (10/s * h)^4 / 120, is then near 1e-13 m
constexpr double kOrderTolerance = 0.2;  // both neighbouring orders are excluded by far

void expectTheOrder(const Scene& scene, const Method& method) {
  EXPECT_NEAR(observedOrder(scene, method), method.order, kOrderTolerance) << method.name;
}

TEST(Orders, OfEveryMethodAreAsDeclaredUnderRelativeDamping) {
  for (const Method& method : methods()) expectTheOrder(softSheet(Damping::Relative), method);
}

TEST(Orders, OfEveryMethodAreAsDeclaredUnderAxialDamping) {
  const Scene scene = softSheet(Damping::Axial);
  for (const Method& method : methods()) {
    if (takes(method, scene)) expectTheOrder(scene, method);
  }
}

TEST(Orders, OfEveryMethodAreAsDeclaredWithoutDamping) {
  Scene scene = softSheet(Damping::Relative);
  scene.structural.kd = scene.shear.kd = scene.bend.kd = scene.drag = 0;
  for (const Method& method : methods()) expectTheOrder(scene, method);
}

/// Particle 7 of the sheet is pushed between two times that no step size divides.
Scene pushedSheet() {
  Scene scene = softSheet(Damping::Relative);
  scene.duration = kSeconds;
  scene.tolerance = 0;  // adaptive methods take steps of dt
  scene.pushes = {{{"", 1, 2}, {3, 1, -2}, 0.1 * std::sqrt(2.0), 0.1 * std::sqrt(7.0)}};
  return scene;
}

Points pushedReference(const Scene& scene) {
  const Push& push = scene.pushes[0];
  const auto pushed = std::size_t(push.particle.row * scene.columns + push.particle.column);
  const Oracle oracle(scene);
  Points at = Bench<double>(scene).points();
  oracle.advance(at, push.at, kReferenceSteps / 4);
  oracle.advance(at, push.duration, kReferenceSteps / 4, pushed, push.force);
  oracle.advance(at, kSeconds - push.at - push.duration, kReferenceSteps / 2);
  return at;
}

TEST(Orders, AreNotLostToAPushThatBeginsAndEndsBetweenSteps) {
  Scene scene = pushedSheet();
  const Points reference = pushedReference(scene);
  for (const Method& method : methods()) {
    const auto errorAt = [&](int steps) {
      scene.dt = kSeconds / steps;
      Simulation simulation(scene, method);
      simulation.advanceTo(kSeconds);
      Points at = reference;
      for (int i = 0; i < simulation.sheet().count(); ++i) at.x[std::size_t(i)] = simulation.position(i);
      return distance(at, reference);
    };
    // The steps of a span shrink unevenly from dt to dt/2: the order is taken over two halvings.
    const int steps = stepsFor(method.order);
    EXPECT_NEAR(std::log2(errorAt(steps) / errorAt(4 * steps)) / 2, method.order, kOrderTolerance) << method.name;
  }
}

TEST(Orders, AnAdaptiveMethodsErrorFollowsItsTolerance) {
  Scene scene = pushedSheet();
  const Points reference = pushedReference(scene);
  for (const Method& method : methods()) {
    if (!method.adaptive) continue;
    double previous = 1;
    for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9}) {
      scene.tolerance = tolerance;
      Simulation simulation(scene, method);
      simulation.advanceTo(kSeconds);
      EXPECT_EQ(simulation.time(), kSeconds);
      Points at = reference;
      for (int i = 0; i < simulation.sheet().count(); ++i) at.x[std::size_t(i)] = simulation.position(i);
      const double error = distance(at, reference);
      EXPECT_LE(error, 30 * tolerance) << method.name << " at " << tolerance;
      EXPECT_LT(error, previous / 5) << method.name << " at " << tolerance;
      previous = error;
    }
  }
}

}  // namespace
}  // namespace tyg::test

// Contact and the orders of methods, from both sides: within the layers, and where particles come and go.
#include <gtest/gtest.h>

#include <cmath>

#include "contact_reference.h"
#include "method_checks.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg::test {
namespace {

/// Where a method's particles are after a second in so many steps.
Points endOf(Scene scene, const Method& method, int steps) {
  scene.duration = 1, scene.tolerance = 0, scene.dt = 1.0 / steps;  // adaptive methods take steps of dt
  Simulation simulation(scene, method);
  simulation.advanceTo(1);
  Points end;
  for (int i = 0; i < simulation.sheet().count(); ++i) {
    end.x.push_back(simulation.position(i)), end.v.push_back(simulation.velocity(i));
  }
  return end;
}

Points referenceOf(const Scene& scene, int steps) {
  Points at = Bench<double>(scene).points();
  ContactReference(scene).advance(at, 1, steps);
  return at;
}

/// imex takes the damping of contact as it is before the step.
int orderWithContact(const Method& method) { return method.name == "imex" ? 1 : method.order; }

void expectOrders(const Scene& scene, const Points& reference) {
  for (const Method& method : methods()) {
    if (!takes(method, scene)) continue;
    const int order = orderWithContact(method), steps = stepsFor(order);
    const double coarse = distance(endOf(scene, method, steps), reference);
    const double fine = distance(endOf(scene, method, 2 * steps), reference);
    EXPECT_GT(std::log2(coarse / fine), order - 0.25) << method.name << " " << coarse << " " << fine;
    EXPECT_LT(std::log2(coarse / fine), order + 0.4) << method.name << " " << coarse << " " << fine;
  }
}

TEST(ContactOrders, OfEveryMethodAreKeptWithinTheLayers) {
  const Scene scene = sheetInLayers();
  expectOrders(scene, referenceOf(scene, 4096));
}

TEST(ContactOrders, ImexKeepsItsSecondOrderWhereContactDoesNotDamp) {
  Scene scene = sheetInLayers();
  scene.contact.damping = scene.contact.friction = 0;
  const Points reference = referenceOf(scene, 4096);
  const Method& method = findMethod("imex");
  const double coarse = distance(endOf(scene, method, 512), reference);
  EXPECT_NEAR(std::log2(coarse / distance(endOf(scene, method, 1024), reference)), 2, 0.2);
}

TEST(ContactOrders, AreKeptByTheOracleOfPlainSpringsAsWell) {
  Scene scene = sheetInLayers();
  scene.bodies.clear(), scene.moves.clear();
  Points plain = Bench<double>(scene).points();
  Oracle(scene).advance(plain, 1, 4096);
  EXPECT_EQ(distance(plain, referenceOf(scene, 4096)), 0);
}

/// A particle that slides along while it bounces twice within a second, off a floor and off a ball.
Scene twoBounces() {
  Scene scene = particleOnFloor();
  scene.contact = {.stiffness = 2, .layer = 0.1, .damping = 0.2, .friction = 0.3, .grip = 0.1};
  scene.bodies = {{.shape = Shape::Plane, .at = {0, -0.3, 0}, .normal = {0.6, 0.8, 0}},
                  {.shape = Shape::Ball, .at = {0.6, -0.9, 0.05}, .radius = 0.5}};
  return scene;
}

TEST(ContactOrders, OfFourAndFiveAreKeptWhereParticlesComeAndGo) {
  const Scene scene = twoBounces();
  const Points reference = referenceOf(scene, 65536);
  for (const char* name : {"rk4", "dopri54"}) {
    const Method& method = findMethod(name);
    // Where exactly a step meets the layer is chance: the order is taken over five halvings.
    const double coarse = distance(endOf(scene, method, 32), reference);
    const double fine = distance(endOf(scene, method, 1024), reference);
    EXPECT_GT(std::log2(coarse / fine) / 5, method.order - 0.4) << name << " " << coarse << " " << fine;
    EXPECT_LT(std::log2(coarse / fine) / 5, method.order + 1) << name << " " << coarse << " " << fine;
  }
}

TEST(ContactOrders, AdaptiveMethodsFollowTheirToleranceThroughContact) {
  Scene scene = twoBounces();
  const Points reference = referenceOf(scene, 65536);
  for (const Method& method : methods()) {
    if (!method.adaptive) continue;
    for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
      scene.tolerance = tolerance;
      Simulation simulation(scene, method);
      simulation.advanceTo(1);
      EXPECT_LT(length(simulation.position(0) - reference.x[0]), 100 * tolerance) << method.name << " " << tolerance;
    }
  }
}

}  // namespace
}  // namespace tyg::test

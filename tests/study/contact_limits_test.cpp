// Step limits of cloth that touches bodies: predicted, certified and measured, and what is said about them.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/scene/bodies.h"
#include "scaled_scene.h"
#include "study/limits/measured_limit.h"
#include "study/limits/stability.h"
#include "study/limits/stability_region.h"
#include "study/limits/stability_study.h"
#include "test_systems.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg::test {
namespace {

/// A soft sheet just above a stiff floor.
Scene softOnFloor(double damping, double friction) {
  Scene scene = emptyWorld(5, 4);
  scene.spacing = 0.1, scene.particleMass = 0.02;
  scene.start = Start::Flat;
  scene.gravity = {0, -9.81, 0};
  scene.structural = {20, 0.02}, scene.shear = {10, 0.01}, scene.bend = {5, 0.01};
  scene.bodies = {{.shape = Shape::Plane, .at = {0, -0.01, 0}}};
  scene.contact = {.stiffness = 2000, .layer = 0.005, .damping = damping, .friction = friction};
  fillContact(scene);
  scene.tolerance = 0;
  return scene;
}

double measured(const Scene& scene, const Method& method) {
  MeasurePlan plan;
  plan.steps = StabilityPlan::kSteps;
  return measuredAtRest(scene, method, plan);
}

TEST(ContactLimit, PredictedIsWhatARestingParticleMeasures) {
  constexpr double kAbove = 0.03, kBelow = 0.005;  // the damping of contact is 0.5 % less than deeper still
  for (const auto& [damping, friction] : {std::pair{0.3, 0.0}, {1.5, 0.0}, {0.05, 0.5}}) {
    Scene scene = softOnFloor(damping, friction);
    if (friction > 0) scene.contact.grip = 40;
    for (const char* name : {"symplectic-euler", "report-rk4", "leapfrog", "rk4", "bs32", "dopri54", "imex"}) {
      const Method& method = findMethod(name);
      const StepLimit limit = stepLimit(scene, method);
      ASSERT_TRUE(limit.byContact) << name;
      EXPECT_EQ(limit.predicted, heldLimit(scene, method)) << name;
      const double found = measured(scene, method);
      EXPECT_GE(found, (1 - kBelow) * limit.predicted) << name << " " << damping << " " << friction;
      EXPECT_LE(found, (1 + kAbove) * limit.predicted) << name << " " << damping << " " << friction;
    }
  }
}

TEST(ContactLimit, OfALimpContactIsThatOfTheSprings) {
  Scene scene = softOnFloor(0.3, 0);
  scene.contact.stiffness = 1;
  fillContact(scene);
  const Method& method = findMethod("rk4");
  EXPECT_FALSE(stepLimit(scene, method).byContact);
  EXPECT_EQ(restLatticeLimit(scene, method), restLatticeLimit(withoutBodies(scene), method));
  EXPECT_NEAR(measured(scene, method) / restLatticeLimit(scene, method), 1, 0.02);
}

Status statusOf(Scene scene, const Method& method, double step, double seconds) {
  scene.dt = step, scene.duration = seconds;
  Simulation simulation(scene, method);
  simulation.advanceTo(seconds);
  return simulation.status();
}

/// Where a mode must be seen to grow within 2000 steps.
double above(const Method& method) { return method.name == "explicit-euler" || method.name == "dopri54" ? 1.3 : 1.1; }

/// Whether the alarm goes, or the particle leaves its place: what bounces may do so for ever without gaining energy.
bool failsToRest(Scene scene, const Method& method, double step) {
  scene.dt = step;
  Simulation simulation(scene, method);
  bool rests = true;
  for (int tick = 0; tick < 2000 && rests; ++tick) simulation.tick(), rests = isResting(simulation);
  return !rests || simulation.check() != Status::Ok;
}

TEST(ContactLimit, ARestingParticleOfRandomContactStaysBelowItAndFailsAbove) {
  Numbers numbers(41);
  for (int draw = 0; draw < 12; ++draw) {
    Scene scene = softOnFloor(numbers.between(0.02, 2), numbers.coin() ? numbers.between(0.1, 1) : 0);
    scene.contact.stiffness = numbers.between(500, 5000);
    scene.contact.grip *= numbers.between(0.2, 4);
    scene.tolerance = 0;
    for (const Method& method : methods()) {
      const double limit = heldLimit(scene, method);
      if (!(limit > 0)) continue;
      const Scene resting = restingParticle(scene);
      EXPECT_FALSE(failsToRest(resting, method, 0.95 * limit)) << method.name << " " << draw;
      EXPECT_TRUE(failsToRest(resting, method, above(method) * limit)) << method.name << " " << draw;
    }
  }
}

/// A cloth of random springs above random bodies that it falls onto.
Scene fallingCloth(Numbers& numbers) {
  Scene scene = emptyWorld(int(numbers.between(3, 8)), int(numbers.between(3, 8)));
  scene.spacing = 0.1, scene.particleMass = numbers.between(0.005, 0.05);
  scene.start = Start::Flat;
  scene.gravity = {0, -9.81, 0};
  const double ks = numbers.between(20, 500), kd = numbers.between(0, 0.3);
  scene.structural = {ks, kd}, scene.shear = {ks * numbers.between(0, 1), kd}, scene.bend = {0.2 * ks, 0.5 * kd};
  scene.bodies = {{.shape = Shape::Plane, .at = {0, -0.05, 0}, .normal = {0, 1, 0}}};
  if (numbers.coin()) {
    scene.bodies.push_back({.shape = Shape::Ball, .at = {0.2, -0.22, 0.2}, .radius = 0.2, .name = "ball"});
    if (numbers.coin()) scene.moves = {{{}, {0, 0.3, 0}, 0.1, 0.2, "ball"}};
  }
  scene.contact.stiffness = ks * numbers.between(0.3, 10);
  scene.contact.damping = numbers.between(0, 1), scene.contact.friction = numbers.coin() ? numbers.between(0.1, 1) : 0;
  if (numbers.coin()) {
    scene.air = {1.2, 1.2};
    scene.winds = {{.velocity = {numbers.between(0, 4), 0, 1}, .gust = {0, 1, 0}, .wavelength = 0.5}};
  }
  fillContact(scene);
  scene.tolerance = 0;
  return scene;
}

TEST(ContactLimit, ACertifiedStepIsSafeInAnyMotionWithBodies) {
  Numbers numbers(43);
  for (int draw = 0; draw < 12; ++draw) {
    Scene scene = fallingCloth(numbers);
    scene.winds.clear(), scene.air = {};
    for (const Method& method : methods()) {
      const double certified = certifiedLimit(scene, method);
      if (!(certified > 0) || !takes(method, scene)) continue;
      EXPECT_EQ(statusOf(scene, method, 0.95 * certified, 1), Status::Ok) << method.name << " " << draw;
    }
  }
}

TEST(ContactLimit, TheRootsOfAParticleOnABodyLeaveTheRegionAtTheLimit) {
  const Scene scene = softOnFloor(0.3, 0);
  for (const char* name : {"leapfrog", "rk4", "imex", "rkc2"}) {
    const Method& method = findMethod(name);
    const double limit = method.stableStep != nullptr ? heldLimit(scene, method) : restLatticeLimit(scene, method);
    const auto growing = [&](double h) {
      const StabilityRegion region = regionOf(method, scene, h);
      const std::vector<std::complex<double>> roots = heldRoots(scene);
      return std::ranges::count_if(roots, [&](const auto& mu) { return !holdsAt(method, region, mu, h, true); });
    };
    EXPECT_EQ(growing(0.99 * limit), 0) << name;
    if (method.stableStep != nullptr) {
      EXPECT_EQ(growing(1.01 * limit), 2) << name;
    }
  }
  EXPECT_TRUE(heldRoots(withoutBodies(scene)).empty());
}

TEST(ContactLimit, TheStagesOfChebyshevHoldContactUpToTheirLimit) {
  Numbers numbers(47);
  const Method& method = findMethod("rkc2");
  for (int draw = 0; draw < 10; ++draw) {
    Scene scene = fallingCloth(numbers);
    scene.winds.clear(), scene.air = {};
    const double limit = restLatticeLimit(scene, method);
    if (!(limit > 0)) continue;
    EXPECT_LE(limit, restLatticeLimit(withoutBodies(scene), method) * 1.001) << draw;
    for (const double share : {0.3, 0.95}) {
      EXPECT_EQ(statusOf(scene, method, share * limit, 1), Status::Ok) << draw << " at " << share << " of " << limit;
    }
  }
}

/// Where contact damps little for its stiffness.
TEST(ContactLimit, TheStagesOfChebyshevHoldAParticleThatRestsAtTheTopOfTheLayer) {
  const Method& method = findMethod("rkc2");
  for (const double damping : {0.1, 0.3, 1.0}) {
    Scene scene = restingParticle(softOnFloor(damping, 0));
    const Contact& contact = scene.contact;
    scene.gravity.y = -0.078 * contact.stiffness * contact.layer / scene.particleMass;
    scene.bodies[0].at.y = 0.5 * contact.layer;
    scene.dt = 0.95 * restLatticeLimit(scene, method);
    Simulation simulation(scene, method);
    simulation.tick(2000);
    EXPECT_LT(std::abs(simulation.position(0).y), 0.01 * contact.layer) << damping;
  }
}

TEST(ContactLimit, IsSaidToBeContactsAndNotTheSprings) {
  Scene scene = softOnFloor(0.3, 0);
  const Method& method = findMethod("leapfrog");
  EXPECT_EQ(describe(scene, stepLimit(scene, method)),
            "a particle on the plane, set by contact with the plane, not the springs");
  scene.bodies[0].name = "table";
  EXPECT_EQ(appearanceOf(scene, stepLimit(scene, method)), "a particle on the table");
  scene.bodies.push_back({.shape = Shape::Ball, .at = {0, -3, 0}, .radius = 1});
  EXPECT_EQ(describe(scene, stepLimit(scene, method)),
            "a particle on the bodies, set by contact with the bodies, not the springs");
  scene.contact.friction = 1, scene.contact.grip = 100;
  EXPECT_EQ(describe(scene, stepLimit(scene, method)),
            "a particle on the bodies, set by friction in contact with the bodies, not the springs");
}

TEST(ContactLimit, OfChebyshevIsContactsWhereItWouldBeLongerWithout) {
  Scene scene = softOnFloor(0.02, 0);
  const StepLimit limit = stepLimit(scene, findMethod("rkc2"));
  EXPECT_TRUE(limit.byContact);
  EXPECT_LT(limit.predicted, restLatticeLimit(withoutBodies(scene), findMethod("rkc2")));
}

TEST(StabilityStudy, MeasuresAndNamesContact) {
  Scene scene = softOnFloor(0.3, 0);
  scene.duration = 0.5;
  StabilityPlan plan;
  plan.methods = {&findMethod("leapfrog")};
  const StabilityStudy study = studyStability(scene, plan);
  ASSERT_EQ(study.cases.size(), 2U);
  for (const StabilityCase& entry : study.cases) {
    EXPECT_TRUE(entry.limit.byContact);
    EXPECT_NEAR(entry.atRest / entry.limit.predicted, 1, 0.03) << entry.damped;
  }
  EXPECT_NE(stabilityCsv(study).find(",contact\n"), std::string::npos) << stabilityCsv(study);
  EXPECT_NE(stabilityTable(study).find("a particle on the plane, contact"), std::string::npos);
}

TEST(LinearRegime, HasNoBodies) {
  const Scene scene = linearRegime(softOnFloor(0.3, 0.5));
  EXPECT_TRUE(scene.bodies.empty());
  EXPECT_EQ(scene.contact, Contact{});
}

TEST(RestingParticle, StaysWhereItRests) {
  constexpr double kTiny = 1e-3;  // layers
  const Scene scene = restingParticle(softOnFloor(0.3, 0.5));
  Simulation simulation(scene, findMethod("rk4"));
  simulation.advanceTo(1);
  EXPECT_LT(std::abs(simulation.position(0).y), kTiny * scene.contact.layer);
}

}  // namespace
}  // namespace tyg::test

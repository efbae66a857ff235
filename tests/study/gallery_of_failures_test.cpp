// The scenes that are there to fail: each does, near where it says, and what it names as a cure holds.
#include <gtest/gtest.h>

#include <map>

#include "core/scene/bodies.h"
#include "study/limits/stability.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg {
namespace {

Scene named(const std::string& name) { return loadScene(name, methodNames()); }

Simulation run(const Scene& scene, const Settings& settings = {}) {
  Simulation simulation(scene, findMethod(scene.integrator), settings);
  simulation.advanceTo(scene.duration);
  return simulation;
}

Status withStep(Scene scene, double dt) {
  scene.dt = dt;
  return run(scene).status();
}

Scene withMethod(Scene scene, const std::string& method) {
  scene.integrator = method;
  return scene;
}

/// What each scene's file names as its cure.
std::map<std::string, std::vector<Scene>> cures() {
  Scene wet = named("fail-wet"), refined = named("fail-refined"), jitter = named("fail-jitter");
  Scene stretched = named("fail-stretched");
  std::map<std::string, std::vector<Scene>> all;
  all["fail-explicit-euler"] = {withMethod(named("fail-explicit-euler"), "symplectic-euler"),
                                withMethod(named("fail-explicit-euler"), "rk4")};
  all["fail-wet"] = {withMethod(wet, "rkc2")};
  wet.dt = 0.0006;
  all["fail-wet"].push_back(wet);
  Scene gentle = named("fail-contact"), fine = gentle;
  gentle.contact.stiffness = largestStiffness(gentle) / 4, fine.dt = 0.0002;
  all["fail-contact"] = {gentle, fine};
  stretched.dt = 0.015;
  all["fail-stretched"] = {stretched};
  jitter.dt = 0.003;
  all["fail-jitter"] = {jitter};
  refined.particleMass = 0.0011, refined.dt = 0.0003, refined.duration = 0.5;  // enough to pass the drop
  all["fail-refined"] = {refined};
  return all;
}

TEST(GalleryOfFailures, EverySceneFailsAndItsCureHolds) {
  const std::map<std::string, std::vector<Scene>> cured = cures();
  for (const BuiltinScene& builtin : builtinScenes()) {
    if (!showsFailure(builtin)) continue;
    const std::string name(builtin.name);
    EXPECT_NE(run(named(name)).status(), Status::Ok) << name;
    ASSERT_TRUE(cured.contains(name)) << name;
    for (const Scene& scene : cured.at(name)) EXPECT_EQ(run(scene).status(), Status::Ok) << name;
  }
}

TEST(GalleryOfFailures, ExplicitEulerFailsLaterWithSmallerSteps) {
  Scene scene = named("fail-explicit-euler");
  EXPECT_EQ(restLatticeLimit(scene, findMethod("explicit-euler")), 0);
  EXPECT_NEAR(run(scene).alarmTime(), 0.19, 0.02);
  scene.dt = 1e-4;
  EXPECT_NEAR(run(scene).alarmTime(), 0.86, 0.05);
}

TEST(GalleryOfFailures, StepsThatAreSaidToHoldDoAndThoseSaidToFailDo) {
  const Scene wet = named("fail-wet"), stretched = named("fail-stretched"), jitter = named("fail-jitter");
  EXPECT_NEAR(restLatticeLimit(wet, findMethod("rk4")), 0.61e-3, 0.005e-3);
  EXPECT_EQ(withStep(wet, 0.62e-3), Status::Ok);
  EXPECT_NE(withStep(wet, 0.63e-3), Status::Ok);
  EXPECT_NEAR(restLatticeLimit(stretched, findMethod("leapfrog")), 18.6e-3, 0.05e-3);
  EXPECT_LT(0.015, certifiedLimit(stretched, findMethod("leapfrog")));
  EXPECT_EQ(withStep(stretched, 0.0165), Status::Ok);
  EXPECT_NE(withStep(stretched, 0.017), Status::Ok);
  EXPECT_NEAR(restLatticeLimit(jitter, findMethod("rk4")), 3.07e-3, 0.005e-3);
  EXPECT_EQ(withStep(jitter, 3.12e-3), Status::Ok);
  EXPECT_NE(withStep(jitter, 3.15e-3), Status::Ok);
}

TEST(GalleryOfFailures, ContactAndNotTheSpringsSetsTheLimitOfTheStiffFloor) {
  const Scene scene = named("fail-contact");
  const Method& leapfrog = findMethod("leapfrog");
  Scene without = scene;
  without.bodies.clear();
  EXPECT_TRUE(stepLimit(scene, leapfrog).byContact);
  EXPECT_NEAR(restLatticeLimit(scene, leapfrog), 0.215e-3, 0.001e-3);
  EXPECT_NEAR(restLatticeLimit(without, leapfrog), 1.13e-3, 0.01e-3);
  EXPECT_EQ(withStep(scene, 0.5e-3), Status::Ok);
  EXPECT_NE(withStep(scene, 0.8e-3), Status::Ok);
}

TEST(GalleryOfFailures, TheJitterStaysInItsBounds) {
  const Scene scene = named("fail-jitter");
  Scene right = scene;
  right.dt = 0.0015;
  Simulation trembling = run(scene, {.keepGoing = true}), calm = run(right);
  EXPECT_EQ(trembling.status(), Status::Unstable);
  EXPECT_GT(trembling.ledger().kinetic, 1000 * calm.ledger().kinetic);
  EXPECT_LT(trembling.ledger().maxStretch, 1.1 * calm.ledger().maxStretch);
}

TEST(GalleryOfFailures, TheRefinedSheetHasTheCoarseSheetsPredictionButStretches) {
  const Scene fine = named("fail-refined");
  Scene coarse = named("curtain");
  const Method& leapfrog = findMethod("leapfrog");
  EXPECT_EQ(restLatticeLimit(fine, leapfrog), restLatticeLimit(coarse, leapfrog));
  coarse.integrator = "leapfrog", coarse.dt = fine.dt;
  EXPECT_EQ(run(coarse).status(), Status::Ok);
  EXPECT_GT(run(fine).ledger().maxStretch, 9);
  EXPECT_EQ(withStep(fine, 2.3e-3), Status::Ok);
  EXPECT_EQ(withStep(fine, 2.4e-3), Status::Unstable);
  EXPECT_EQ(withStep(fine, 2.5e-3), Status::Unstable);
}

}  // namespace
}  // namespace tyg

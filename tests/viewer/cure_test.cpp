// The ways out of a failure hold.
#include "viewer/cure.h"

#include <gtest/gtest.h>

#include "study/limits/stability.h"
#include "tyg/methods.h"

namespace tyg::test {
namespace {

Status after(Scene scene, const Method& method, double dt) {
  scene.dt = dt;
  Simulation simulation(scene, method, {.threads = 1});
  simulation.advanceTo(scene.duration);
  return simulation.status();
}

TEST(Cure, OfAStretchedClothHoldsInTheStretchedCloth) {
  const Scene scene = loadScene("fail-stretched");
  const Method& leapfrog = findMethod("leapfrog");
  Simulation simulation(scene, leapfrog, {.threads = 1});
  simulation.advanceTo(scene.duration);
  ASSERT_NE(simulation.status(), Status::Ok);
  const double rest = restLatticeLimit(scene, leapfrog), live = 0.98 * scene.dt;
  ASSERT_GT(restLatticeLimit(scene, findMethod("symplectic-euler")), 1.05 * scene.dt)
      << "it seems to hold and does not";
  for (const double limit : {rest, live}) {
    const Cure cure = findCure(simulation, limit);
    ASSERT_NE(cure.method, nullptr);
    EXPECT_EQ(after(scene, *cure.method, scene.dt), Status::Ok) << cure.method->name << " " << limit;
    EXPECT_LT(cure.step, scene.dt);
    EXPECT_EQ(after(scene, leapfrog, cure.step), Status::Ok) << cure.step;
  }
}

TEST(Cure, IsAnotherMethodAloneWhereNoStepHolds) {
  const Scene scene = loadScene("fail-explicit-euler");
  Simulation simulation(scene, findMethod("explicit-euler"), {.threads = 1});
  simulation.advanceTo(scene.duration);
  const Cure cure = findCure(simulation, 0);
  EXPECT_EQ(cure.step, 0);
  ASSERT_NE(cure.method, nullptr);
  EXPECT_EQ(after(scene, *cure.method, scene.dt), Status::Ok) << cure.method->name;
}

TEST(Cure, OfAMethodWithoutALimitIsAStepThatHolds) {
  Scene scene = loadScene("chain", methodNames());
  scene.integrator = "xpbd", scene.dt = 0.01;
  Simulation simulation(scene, findMethod("xpbd"), {.threads = 1});
  simulation.advanceTo(scene.duration);
  ASSERT_EQ(simulation.status(), Status::Unstable);
  const Cure cure = findCure(simulation, std::numeric_limits<double>::quiet_NaN());
  EXPECT_GT(cure.step, 0);
  EXPECT_LT(cure.step, scene.dt / 2) << "half the step fails earlier";
  scene.dt = cure.step;
  Simulation cured(scene, findMethod("xpbd"), {.threads = 1});
  cured.advanceTo(scene.duration);
  EXPECT_EQ(cured.status(), Status::Ok);
}

}  // namespace
}  // namespace tyg::test

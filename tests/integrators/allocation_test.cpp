// A running simulation allocates nothing: ten times as many steps take not one allocation more.
#include <gtest/gtest.h>

#include <cmath>

#include "counted_allocations.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg {
namespace {

TEST(Allocation, DoesNotGrowWithTheNumberOfSteps) {
  Scene scene = loadScene("curtain");
  scene.dt = 0.0005;
  for (const Method& method : methods()) {
    Simulation simulation(scene, method, {.keepGoing = true});
    simulation.advanceTo(64 * scene.dt);  // the first steps may set up what a step length needs
    const auto allocatedBy = [&](double time) {
      const long before = allocations;
      simulation.advanceTo(time);
      return allocations - before;
    };
    const long few = allocatedBy(128 * scene.dt), many = allocatedBy(768 * scene.dt);
    EXPECT_LE(many, few) << method.name;
    EXPECT_GE(simulation.steps(), 100) << method.name;
  }
}

TEST(Allocation, HappensInTheFirstCallForTheLiveLimitOnly) {
  for (const Method& method : methods()) {
    Simulation simulation(loadScene("curtain"), method);
    const double first = simulation.liveStableStep();
    const long before = allocations;
    for (int call = 0; call < 5; ++call) {
      EXPECT_EQ(std::isnan(simulation.liveStableStep()), std::isnan(first)) << method.name;
    }
    EXPECT_EQ(allocations, before) << method.name;
  }
}

}  // namespace
}  // namespace tyg

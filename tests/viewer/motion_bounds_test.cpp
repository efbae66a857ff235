// The room that a motion takes is found within the time that an opening window may take.
#include <gtest/gtest.h>

#include "test_systems.h"
#include "tyg/methods.h"
#include "util/calibration_clock.h"
#include "view/box.h"
#include "viewer/motion_bounds.h"

namespace tyg::test {
namespace {

/// Waiting for the end of a tick would take the test's time limit.
TEST(MotionBounds, OfAClothWhoseTickWouldTakeHoursAreFoundSoon) {
  Scene scene = emptyWorld(3, 3);
  scene.structural = {1000, 1e8};
  scene.pins = {{"top-left"}};
  scene.gravity = {0, -9.81, 0};
  scene.dt = 0.01;
  const Simulation simulation(scene, findMethod("bs32"));
  std::vector<float> xyz(27);
  simulation.copyPositions(xyz);
  const double began = wallClock();
  EXPECT_FALSE(motionBounds(simulation, boxAround(xyz), {}, wallClock).empty());
  EXPECT_LT(wallClock() - began, 20);
}

}  // namespace
}  // namespace tyg::test

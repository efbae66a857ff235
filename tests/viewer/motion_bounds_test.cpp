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

/// Nothing holds the cloth: a trial run without bodies would tell of a fall that never ends.
TEST(MotionBounds, OfAClothThatFallsOntoAFloorReachDownToIt) {
  Scene scene = emptyWorld(3, 3);
  scene.start = Start::Flat;
  scene.spacing = 0.5;
  scene.gravity = {0, -9.81, 0};
  scene.dt = 1e-3;
  scene.bodies = {{.shape = Shape::Plane, .at = {0, -0.6, 0}}};
  scene.contact.stiffness = 1e5;
  fillContact(scene);
  const auto boundsOf = [](const Scene& of) {
    const Simulation simulation(of, findMethod("rk4"));
    std::vector<float> xyz(27);
    simulation.copyPositions(xyz);
    const std::vector<glm::vec3> points = motionBounds(simulation, boxAround(xyz), {}, [] { return 0.0; });
    return boxAround({&points[0].x, 3 * points.size()});
  };
  EXPECT_NEAR(boundsOf(scene).low.y, -0.6, 0.05);
  scene.bodies[0].at.y = -100;  // farther away than what still leaves the cloth large in the view
  EXPECT_NEAR(boundsOf(scene).low.y, -1.06, 0.05);
}

}  // namespace
}  // namespace tyg::test

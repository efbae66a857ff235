// A sheet too large to be factored moves as the same cloth does by another method with small steps.
#include <gtest/gtest.h>

#include <cmath>

#include "test_systems.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg::test {
namespace {

Scene largeSheet(double kd) {
  Scene scene = emptyWorld(300, 230);  // more particles than imex factors
  scene.particleMass = 0.01;
  scene.structural = {10, kd};
  scene.pins = {{"top"}};
  scene.gravity = {0, -9.81, 0};
  scene.drag = 0.01;
  scene.displacements = {{{"middle"}, {0.02, 0.03, 0.05}}};
  scene.dt = 0.004;
  return scene;
}

TEST(LargeImex, MovesAsASmallStepOfAnotherMethodDoes) {
  Scene scene = largeSheet(0.05);
  Simulation imex(scene, findMethod("imex"));
  scene.dt = 0.0005;
  Simulation exact(scene, findMethod("rk4"));
  imex.advanceTo(0.02), exact.advanceTo(0.02);
  const int middle = particleAt(imex.sheet(), {"middle"});
  double moved = 0, apart = 0;
  for (const int particle : {middle, middle + 1, middle - 300, 1000, 68000}) {
    const Vec3 a = imex.position(particle), b = exact.position(particle), start = exact.sheet().startPosition(particle);
    moved = std::max(moved, std::hypot(b.x - start.x, b.y - start.y, b.z - start.z));
    apart = std::max(apart, std::hypot(a.x - b.x, a.y - b.y, a.z - b.z));
  }
  EXPECT_GT(moved, 0.01);
  EXPECT_LT(apart, 3e-3 * moved);  // second order at four of its ten steps a radian
}

TEST(LargeImex, GoesOnFromACopyWithTheSameBits) {
  const Scene scene = largeSheet(0.05);
  Simulation simulation(scene, findMethod("imex"));
  simulation.tick(2);
  const Snapshot copy = simulation.save();
  simulation.tick(2);
  const std::uint64_t there = simulation.hash();
  simulation.restore(copy);
  simulation.tick(2);
  EXPECT_EQ(simulation.hash(), there);
}

}  // namespace
}  // namespace tyg::test

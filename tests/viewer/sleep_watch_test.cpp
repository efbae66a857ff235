// When a cloth has come to rest: relative to its own size and times, and never while a slow motion goes on.
#include "viewer/sleep_watch.h"

#include <gtest/gtest.h>

#include "scaled_scene.h"
#include "test_systems.h"
#include "tyg/methods.h"

namespace tyg::test {
namespace {

/// The time at which the watch says that a scene sleeps, s; nothing within its duration.
std::optional<double> sleepTime(const Scene& scene) {
  Simulation simulation(scene, findMethod(scene.integrator), {.threads = 1});
  SleepWatch watch;
  constexpr int kTicksAFrame = 8;
  while (simulation.time() < scene.duration) {
    simulation.tick(kTicksAFrame);
    watch.follow(simulation, simulation.ledger().kinetic);
    if (watch.asleep(simulation.time())) return simulation.time();
  }
  return {};
}

Scene hung(int size) {
  Scene scene = withSheet(loadScene("curtain"), size, size);
  scene.integrator = "leapfrog";
  scene.pins = {{"top"}};
  scene.start = Start::Hanging;
  return scene;
}

TEST(SleepWatch, SaysThatADampedClothComesToRest) {
  Scene scene = hung(6);
  scene.spacing = 0.1, scene.particleMass = 0.018, scene.drag = 0.2, scene.dt = 0.001, scene.duration = 60;
  const std::optional<double> time = sleepTime(scene);
  ASSERT_TRUE(time);
  Simulation simulation(scene, findMethod(scene.integrator), {.threads = 1});
  Simulation later(scene, findMethod(scene.integrator), {.threads = 1});
  simulation.advanceTo(*time);
  later.advanceTo(2 * *time);
  for (int particle = 0; particle < 36; ++particle) {
    EXPECT_LT(length(later.position(particle) - simulation.position(particle)), 2 * SleepWatch::kUnseen);
  }
}

TEST(SleepWatch, LetsNothingSleepWhileGustsBlowOrAMotionIsToCome) {
  Scene scene = hung(6);
  scene.spacing = 0.1, scene.particleMass = 0.018, scene.drag = 0.2, scene.dt = 0.001, scene.duration = 60;
  scene.moves = {{{{"top"}}, {}, 60, 1}};
  EXPECT_FALSE(sleepTime(scene));
  scene.moves.clear();
  scene.cuts = {{{0.5, -1, 0.5, 5}, 60}};
  EXPECT_FALSE(sleepTime(scene));
  scene.cuts.clear();
  scene.air = {1.2, 1.2}, scene.winds = {{.velocity = {0, 0, 1}, .gust = {1e-9, 0, 0}, .wavelength = 1000}};
  EXPECT_FALSE(sleepTime(scene));
  scene.winds[0].gust = {}, scene.winds[0].wavelength = 0;
  EXPECT_TRUE(sleepTime(scene)) << "in a steady wind it comes to rest";
}

TEST(SleepWatch, LetsNothingSleepThatFallsInTheWeakestGravity) {
  for (const Precision precision : {Precision::Float, Precision::Double}) {
    for (const double gravity : {5e-4, 1e-6, 1e-9}) {
      Scene scene = hung(4);
      scene.start = Start::Flat;
      scene.precision = precision;
      scene.gravity = {0, -gravity, 0};
      scene.dt = 0.002, scene.duration = 20;
      EXPECT_FALSE(sleepTime(scene)) << gravity;
    }
  }
}

TEST(SleepWatch, LetsNothingSleepThatCreepsSteadily) {
  Scene scene = freeFall();
  scene.integrator = "leapfrog";
  scene.drag = scene.particleMass * 9.81 / 0.49e-3;  // 0.49 mm/s
  scene.dt = 2e-5, scene.duration = 10;
  EXPECT_FALSE(sleepTime(scene));
}

TEST(SleepWatch, LetsWhatNothingMovesSleep) {
  Scene scene = hung(4);
  scene.gravity = {};
  scene.duration = 30, scene.dt = 0.002;
  EXPECT_TRUE(sleepTime(scene));
}

TEST(SleepWatch, SaysTheSameInAnyUnits) {
  Scene scene = hung(6);
  scene.spacing = 0.1, scene.particleMass = 0.018, scene.drag = 0.2, scene.dt = 0.001, scene.duration = 60;
  const std::optional<double> expected = sleepTime(scene);
  ASSERT_TRUE(expected);
  for (const Units& units : kUnits) {
    const std::optional<double> found = sleepTime(scaled(scene, units));
    ASSERT_TRUE(found);
    EXPECT_EQ(*found / units.time, *expected);
  }
}

}  // namespace
}  // namespace tyg::test

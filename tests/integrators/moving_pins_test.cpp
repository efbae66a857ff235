// Pins that move: where they end, the work that they do, and that every method takes them.
#include <gtest/gtest.h>

#include <cmath>

#include "test_systems.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg::test {
namespace {

/// Both corners move together, and one of them upwards for a while that no step divides.
Scene movedSheet() {
  Scene scene = softSheet(Damping::Relative);
  scene.moves = {{.what = {{"top-left"}, {"top-right"}}, .velocity = {0.5, 0, -0.25}, .at = 0.11, .duration = 0.4},
                 {.what = {{"top-left"}}, .velocity = {0, 0.3, 0}, .at = 0.21, .duration = 1.0 / 3}};
  scene.dt = 0.01;
  return scene;
}

TEST(MovingPins, EndWhereTheirVelocityTimesTheDurationBringsThem) {
  constexpr double kRounding = 1e-15;  // m: of a few sums of numbers below 2
  for (const Method& method : methods()) {
    const Scene scene = movedSheet();
    Simulation simulation(scene, method);
    const Vec3 left = simulation.position(0), right = simulation.position(2);
    simulation.advanceTo(1);
    EXPECT_LE(length(simulation.position(0) - left - Vec3{0.2, 0.1, -0.1}), kRounding) << method.name;
    EXPECT_LE(length(simulation.position(2) - right - Vec3{0.2, 0, -0.1}), kRounding) << method.name;
    EXPECT_EQ(simulation.velocity(0), Vec3{}) << method.name;
    EXPECT_EQ(simulation.status(), Status::Ok) << method.name;
  }
}

TEST(MovingPins, HaveTheirVelocityMeanwhile) {
  for (const Method& method : methods()) {
    Simulation simulation(movedSheet(), method);
    simulation.advanceTo(0.3);
    EXPECT_LE(length(simulation.velocity(0) - Vec3{0.5, 0.3, -0.25}), 1e-14) << method.name;
    EXPECT_LE(length(simulation.velocity(2) - Vec3{0.5, 0, -0.25}), 1e-14) << method.name;
  }
}

TEST(MovingPins, DoWorkThatTheLedgerKnows) {
  for (const auto& [name, most] : {std::pair{"rk4", 1e-7},
                                   {"dopri54", 1e-7},
                                   {"rkc2", 1e-3},
                                   {"leapfrog", 1e-3},
                                   {"imex", 1e-3},
                                   {"symplectic-euler", 3e-2},
                                   {"backward-euler", 5e-2},
                                   {"xpbd", 5e-2}}) {
    Scene scene = movedSheet();
    scene.dt = 2e-3, scene.tolerance = 0;
    Simulation simulation(scene, findMethod(name), {.ledger = true});
    simulation.advanceTo(1);
    const Ledger ledger = simulation.ledger();
    EXPECT_LT(std::abs(ledger.drift), most) << name;
    EXPECT_GT(std::abs(ledger.work["pins"]), 0.01) << name;
  }
}

TEST(MovingPins, BringMomentumByTheForcesOnThem) {
  // A chain on its two ends, pulled along: in the end it hangs as it did, elsewhere.
  Scene scene = hangingChain(4, 0.25, 0.1, {200, 2});
  scene.drag = 0.2;
  scene.moves = {{.what = {{"top-left"}}, .velocity = {1, 0, 0}, .at = 0.5, .duration = 0.5}};
  Scene still = scene;
  still.moves.clear();
  Simulation moved(scene, findMethod("rk4")), unmoved(still, findMethod("rk4"));
  moved.advanceTo(20), unmoved.advanceTo(20);
  for (int i = 0; i < 5; ++i) {
    EXPECT_LE(length(moved.position(i) - unmoved.position(i) - Vec3{0.5, 0, 0}), 1e-6) << i;
  }
}

TEST(MovingPins, GiveTheSameBitsInOneCallAndTickByTickAndAfterGoingBack) {
  for (const Precision precision : {Precision::Float, Precision::Double}) {
    for (const Method& method : methods()) {
      Scene scene = movedSheet();
      scene.precision = precision;
      Simulation together(scene, method, {.threads = 2}), single(scene, method, {.threads = 1});
      together.tick(60);
      for (int k = 0; k < 30; ++k) single.tick();
      const Snapshot half = single.save();
      for (int k = 0; k < 30; ++k) single.tick();
      EXPECT_EQ(together.hash(), single.hash()) << method.name;
      const std::uint64_t hash = single.hash();
      const double work = single.ledger().work["pins"];
      single.restore(half);
      single.tick(30);
      EXPECT_EQ(single.hash(), hash) << method.name;
      EXPECT_EQ(single.ledger().work["pins"], work) << method.name;
    }
  }
}

TEST(MovingPins, OnlyPinsMove) {
  Scene scene = movedSheet();
  scene.moves[0].what = {{"middle"}};
  EXPECT_THROW(Simulation(scene, findMethod("rk4")), InputError);
}

TEST(MovingPins, IgnorePushes) {
  Scene scene = movedSheet();
  scene.pushes = {{{"top-left"}, {1, 2, 3}, 0.2, 0.2}};
  Scene alone = movedSheet();
  Simulation pushed(scene, findMethod("rk4"), {.ledger = true});
  pushed.advanceTo(1);
  EXPECT_EQ(pushed.ledger().work["pushes"], 0);
  EXPECT_LT(std::abs(pushed.ledger().drift), 1e-6);
}

}  // namespace
}  // namespace tyg::test

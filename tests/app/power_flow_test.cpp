// Power in systems whose powers are known.
#include "app/power_flow.h"

#include <gtest/gtest.h>

#include "test_systems.h"
#include "tyg/methods.h"

namespace tyg::test {
namespace {

/// The meter after some frames of a sixtieth of a second each.
PowerFlow flowAfter(Scene scene, int frames, double* speed = nullptr) {
  Simulation simulation(scene, findMethod("rk4"), {.threads = 1, .ledger = true});
  PowerMeter meter;
  for (int frame = 0; frame <= frames; ++frame) {
    simulation.advanceTo(frame / 60.0);
    meter.take(simulation.time(), simulation.ledger());
  }
  if (speed != nullptr) *speed = -simulation.velocity(0).y;
  return meter.flow();
}

TEST(PowerFlow, OfAParticleThatFallsAtItsFinalSpeedGoesFromGravityToDrag) {
  Scene scene = freeFall();
  scene.drag = 20;
  scene.dt = 0.002;
  double speed = 0;
  const PowerFlow flow = flowAfter(scene, 600, &speed);
  const double power = scene.particleMass * 9.81 * speed;
  constexpr double kTolerance = 1e-3;  // of the power: what is left of the beginning
  EXPECT_NEAR(flow.gravity, power, kTolerance * power);
  EXPECT_NEAR(flow.dampers, power, kTolerance * power);
  EXPECT_NEAR(flow.kinetic, 0, kTolerance * power);
  EXPECT_EQ(flow.springs, 0);
}

TEST(PowerFlow, BalancesWhereTheMethodIsExactEnough) {
  Scene scene = softSheet(Damping::Relative);
  scene.dt = 0.002;
  const PowerFlow flow = flowAfter(scene, 40);
  const double through = std::abs(flow.gravity) + std::abs(flow.springs) + std::abs(flow.dampers);
  EXPECT_GT(through, 0);
  EXPECT_LT(std::abs(flow.missing), 1e-4 * through);
}

TEST(PowerFlow, BeginsAnewWhenTheClothGoesBack) {
  PowerMeter meter;
  Ledger ledger;
  meter.take(0, ledger);
  ledger.kinetic = 1;
  meter.take(1, ledger);
  EXPECT_GT(meter.flow().kinetic, 0);
  meter.take(0.5, ledger);
  EXPECT_EQ(meter.flow().kinetic, 0);
}

}  // namespace
}  // namespace tyg::test

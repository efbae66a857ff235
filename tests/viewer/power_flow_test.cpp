// Power in systems whose powers are known.
#include "viewer/power_flow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "test_systems.h"
#include "tyg/methods.h"

namespace tyg::test {
namespace {

/// Over the last fifth of a second before this time, s.
PowerFlow flowAt(double time, const Scene& scene, double* speed = nullptr) {
  constexpr double kSeconds = 0.2;
  Simulation simulation(scene, findMethod("rk4"), {.threads = 1, .ledger = true});
  simulation.advanceTo(time - kSeconds);
  const Ledger before = simulation.ledger();
  simulation.advanceTo(time);
  if (speed != nullptr) *speed = -simulation.velocity(0).y;
  return powerBetween(before, simulation.ledger(), kSeconds);
}

double wattsOf(std::span<const PowerFlow::Bond> bonds, std::string_view name) {
  const auto bond = std::ranges::find(bonds, name, &PowerFlow::Bond::name);
  return bond == bonds.end() ? NAN : bond->watts;
}

TEST(PowerFlow, OfAParticleThatFallsAtItsFinalSpeedGoesFromGravityToDrag) {
  Scene scene = freeFall();
  scene.drag = 20;
  scene.dt = 0.002;
  double speed = 0;
  const PowerFlow flow = flowAt(10, scene, &speed);
  const double power = scene.particleMass * 9.81 * speed;
  constexpr double kTolerance = 1e-3;  // of the power: what is left of the beginning
  EXPECT_NEAR(wattsOf(flow.sources(), "gravity"), power, kTolerance * power);
  EXPECT_NEAR(wattsOf(flow.sinks(), "dampers"), power, kTolerance * power);
  EXPECT_NEAR(flow.kinetic(), 0, kTolerance * power);
  EXPECT_EQ(wattsOf(flow.sinks(), "springs"), 0);
}

TEST(PowerFlow, BalancesWhereTheMethodIsExactEnough) {
  Scene scene = softSheet(Damping::Relative);
  scene.dt = 0.002;
  const PowerFlow flow = flowAt(0.7, scene);
  const double through = std::abs(wattsOf(flow.sources(), "gravity")) + std::abs(wattsOf(flow.sinks(), "springs")) +
                         std::abs(wattsOf(flow.sinks(), "dampers"));
  EXPECT_GT(through, 0);
  EXPECT_LT(std::abs(flow.missing()), 1e-4 * through);
}

}  // namespace
}  // namespace tyg::test

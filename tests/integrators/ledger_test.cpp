// The ledger of energy: what goes in, what is stored and what is taken add up, the better the smaller the step.
#include <gtest/gtest.h>

#include "method_checks.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg::test {
namespace {

/// Damping, drag, gravity and a push whose edges no step divides.
Scene busyScene(Damping damping) {
  Scene scene = softSheet(damping);
  scene.tolerance = 0;  // adaptive methods take steps of dt
  scene.pushes = {{{"middle"}, {2, 1, -2}, 0.1 * std::sqrt(2.0), 0.1 * std::sqrt(7.0)}};
  return scene;
}

Ledger ledgerAfter(const Scene& scene, const Method& method, double seconds) {
  Simulation simulation(scene, method, {.ledger = true});
  simulation.advanceTo(seconds);
  return simulation.ledger();
}

TEST(Ledger, ClosesToTheOrderOfTheMethod) {
  for (const Method& method : methods()) {
    Scene scene = busyScene(Damping::Relative);
    const auto drift = [&](double dt) {
      scene.dt = dt;
      return std::abs(ledgerAfter(scene, method, 1).drift);
    };
    const double dt = method.order == 1 ? 1.0 / 1024 : method.order == 2 ? 1.0 / 256 : 1.0 / 64;
    const double coarse = drift(dt), fine = drift(dt / 4);
    // Two halvings; a ledger may close better than its method's order, and at least to half an order below it.
    EXPECT_LT(fine, coarse / std::pow(4, method.order - 0.5))
        << method.name << " coarse " << coarse << " fine " << fine;
    EXPECT_LT(coarse, 0.01) << method.name;
  }
}

TEST(Ledger, KnowsTheWorkOfAPushOnAFreeParticle) {
  Scene scene = emptyWorld(1, 1);
  scene.particleMass = 2;
  scene.dt = 0.01;
  scene.pushes = {{{"middle"}, {3, 0, 4}, 0.25, 0.5}};
  const Ledger ledger = ledgerAfter(scene, findMethod("rk4"), 1);
  const double work = 5.0 / 2 * 5 * 0.5 * 0.5 / 2;  // force times (force / mass) t^2 / 2
  EXPECT_NEAR(ledger.work.sum(), work, 1e-13);
  EXPECT_NEAR(ledger.kinetic, work, 1e-13);
  EXPECT_EQ(ledger.dissipated, 0);
}

TEST(Ledger, KnowsWhatDragTakes) {
  Scene scene = freeFall();
  scene.drag = 2;
  scene.dt = 0.005;
  const double d = scene.drag / scene.particleMass, t = 3, g = 9.81;
  const double fallen = g / d * (t - (1 - std::exp(-d * t)) / d), speed = g / d * (1 - std::exp(-d * t));
  const Ledger ledger = ledgerAfter(scene, findMethod("rk4"), t);
  EXPECT_NEAR(ledger.stored["gravitational"], -g * fallen, 1e-8);
  EXPECT_NEAR(ledger.kinetic, speed * speed / 2, 1e-8);
  EXPECT_NEAR(ledger.dissipated, g * fallen - speed * speed / 2, 1e-8);
}

TEST(Ledger, TakesAllTheEnergyOfADampedSpringInTheEnd) {
  Scene scene = oscillator(100, 5);
  scene.displacements = {{{"top-right"}, {0.2, 0, 0}}};
  scene.dt = 0.002;
  const Ledger ledger = ledgerAfter(scene, findMethod("rk4"), 10);
  const double stored = 100 * 0.2 * 0.2 / 2;
  EXPECT_NEAR(ledger.dissipated, stored, 1e-8 * stored);
  EXPECT_NEAR(ledger.stored["elastic"] + ledger.kinetic, 0, 1e-15);
  EXPECT_NEAR(ledger.maxStretch, 0.2, 1e-12);
  EXPECT_NEAR(ledger.scale, stored + 100 * 0.01 * 0.01 / 2, 1e-12);
}

TEST(Ledger, OfAnUndampedSwingKeepsItsSumWithEachSecondOrderMethod) {
  constexpr double kShare = 1e-4;  // of the scale: the bounded wobble of a second order method at h w = 0.05
  for (const Method& method : methods()) {
    if (method.order < 2) continue;
    EXPECT_LE(undampedDrift(method), kShare) << method.name;
  }
}

TEST(Ledger, CanBeFollowedFromTheMiddleOfARunAndAcrossAReturn) {
  constexpr double kDrift = 0.01;  // as from the start
  Scene scene = busyScene(Damping::Relative);
  scene.dt = 1.0 / 512;
  for (const Method& method : methods()) {
    Simulation simulation(scene, method), plain(scene, method);
    simulation.advanceTo(0.5), plain.advanceTo(0.5);
    const Snapshot before = simulation.save();
    simulation.followLedger(true);
    EXPECT_EQ(simulation.ledger().drift, 0) << method.name;
    simulation.advanceTo(1), plain.advanceTo(1);
    EXPECT_LT(std::abs(simulation.ledger().drift), kDrift) << method.name;
    EXPECT_GT(simulation.ledger().dissipated, 0) << method.name;
    EXPECT_EQ(simulation.hash(), plain.hash()) << method.name;
    simulation.restore(before);
    EXPECT_EQ(simulation.ledger().drift, 0) << method.name;
    simulation.advanceTo(1);
    EXPECT_LT(std::abs(simulation.ledger().drift), kDrift) << method.name;
    EXPECT_EQ(simulation.hash(), plain.hash()) << method.name;
  }
}

TEST(Ledger, AfterAReturnTakesWhatItWouldHaveTaken) {
  Scene scene = busyScene(Damping::Relative);
  scene.dt = 1.0 / 256;
  for (const Method& method : methods()) {
    Simulation simulation(scene, method, {.ledger = true});
    simulation.tick(50);
    const Snapshot moment = simulation.save();
    simulation.tick(20);
    const double dissipated = simulation.ledger().dissipated;
    simulation.restore(moment);
    simulation.tick(20);
    EXPECT_EQ(simulation.ledger().dissipated, dissipated) << method.name;
  }
}

TEST(Ledger, IsAFractionOfWhatTheRunHasSeenWhateverTheStep) {
  Scene scene = freeFall();
  scene.dt = 0.5;
  const Ledger ledger = ledgerAfter(scene, findMethod("explicit-euler"), 1);
  EXPECT_EQ(ledger.scale, -ledger.stored["gravitational"]);
  EXPECT_EQ(ledgerAfter(scene, findMethod("rk4"), 0).drift, 0) << "of nothing at all";
}

TEST(Ledger, CostsNoBits) {
  const Scene scene = busyScene(Damping::Axial);
  Simulation with(scene, findMethod("rk4"), {.ledger = true}), without(scene, findMethod("rk4"));
  with.advanceTo(1);
  without.advanceTo(1);
  EXPECT_EQ(with.hash(), without.hash());
}

}  // namespace
}  // namespace tyg::test

// Air, wind and time: closed forms, orders from both sides, the same bits, and a ledger that closes.
#include <gtest/gtest.h>

#include <cmath>

#include "core/forces/row_kernel.h"
#include "method_checks.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg::test {
namespace {

constexpr double kMass = 0.01, kSpacing = 0.5, kDensity = 1.2, kCoefficient = 1.1;  // kg, m, kg/m3

/// A free sheet of one cell.
Scene oneCell() {
  Scene scene = emptyWorld(2, 2);
  scene.start = Start::Flat;
  scene.spacing = kSpacing, scene.particleMass = kMass;
  scene.structural.ks = scene.shear.ks = 100;
  scene.air = {kDensity, kCoefficient};
  scene.dt = 1e-3, scene.tolerance = 1e-8;
  return scene;
}

TEST(Air, SlowsAFallingSheetToItsFinalSpeed) {
  constexpr double kGravity = 9.81, kSeconds = 0.7;
  Scene scene = oneCell();
  scene.gravity = {0, -kGravity, 0};
  const double last = std::sqrt(8 * kMass * kGravity / (kDensity * kCoefficient * kSpacing * kSpacing));
  for (const Method& method : methods()) {
    if (!takes(method, scene)) continue;
    Simulation simulation(scene, method);
    simulation.advanceTo(kSeconds);
    const double tolerance = method.order > 1 ? 1e-5 : 1e-2;
    EXPECT_NEAR(-simulation.velocity(3).y, last * std::tanh(kGravity * kSeconds / last), tolerance) << method.name;
  }
}

TEST(Air, CarriesASheetAwayWithTheWind) {
  constexpr double kWind = 3, kSeconds = 0.5;
  Scene scene = oneCell();
  scene.winds = {{.velocity = {0, kWind, 0}}};
  const double length = 8 * kMass / (kDensity * kCoefficient * kSpacing * kSpacing);
  Simulation simulation(scene, findMethod("rk4"), {.ledger = true});
  simulation.advanceTo(kSeconds);
  EXPECT_NEAR(kWind - simulation.velocity(0).y, kWind / (1 + kWind * kSeconds / length), 1e-9);
  const Ledger ledger = simulation.ledger();
  EXPECT_GT(ledger.work["wind"], 0);
  EXPECT_GT(ledger.dissipated, 0);
  EXPECT_NEAR(ledger.mechanical() + ledger.dissipated, ledger.work.sum(), 1e-9 * ledger.work.sum());
}

TEST(Air, HoldsAHingedCellAtTheAngleAtWhichItBalancesItsWeight) {
  constexpr double kWind = 2, kGravity = 9.81;
  Scene scene = oneCell();
  scene.start = Start::Hanging;
  scene.structural.ks = scene.shear.ks = 1e4;
  scene.structural.kd = scene.shear.kd = 0.5;
  scene.drag = 0.05;
  scene.dt = 5e-4;
  scene.gravity = {0, -kGravity, 0};
  scene.pins = {{"top"}};
  scene.winds = {{.velocity = {0, 0, kWind}}};
  Simulation simulation(scene, findMethod("leapfrog"));
  simulation.advanceTo(60);
  const Vec3 low = simulation.position(2), high = simulation.position(0);
  const double tangent = (low.z - high.z) / (high.y - low.y);
  // F (s/2) = m g s sin a for both lower corners, F = rho C A U^2 cos a / 2
  const double expected = kDensity * kCoefficient * kSpacing * kSpacing * kWind * kWind / (8 * kMass * kGravity);
  EXPECT_NEAR(tangent, expected, 2e-3 * expected);
}

/// A soft sheet in a wind with gusts that change smoothly within a step of a hundredth of a second.
Scene gustySheet() {
  Scene scene = softSheet(Damping::Relative);
  scene.air = {1.0, 1.2};
  scene.winds = {{.velocity = {2, 0.5, 1}, .gust = {0.5, 2, -1}, .wavelength = 6}};
  return scene;
}

TEST(Air, CostsNoMethodItsOrderThoughItDependsOnTime) {
  Scene scene = gustySheet();
  scene.duration = 1, scene.tolerance = 0;
  const auto end = [&](const Method& method, int steps) {
    scene.dt = 1.0 / steps;
    Simulation simulation(scene, method);
    simulation.advanceTo(1);
    std::vector<Vec3> at;
    for (int i = 0; i < simulation.sheet().count(); ++i) at.push_back(simulation.position(i));
    return at;
  };
  const std::vector<Vec3> reference = end(findMethod("rk4"), 4096);
  for (const Method& method : methods()) {
    if (!takes(method, scene)) continue;
    const auto errorAt = [&](int steps) {
      const std::vector<Vec3> at = end(method, steps);
      double sum = 0;
      for (std::size_t i = 0; i < at.size(); ++i) sum += std::pow(length(at[i] - reference[i]), 2);
      return std::sqrt(sum);
    };
    const int steps = 2 * stepsFor(method.order);
    EXPECT_NEAR(std::log2(errorAt(steps) / errorAt(2 * steps)), method.order, 0.25) << method.name;
  }
}

TEST(Air, GivesTheSameBitsInOneCallAndTickByTickForEveryMethodAndThread) {
  Scene scene = gustySheet();
  scene.columns = 9, scene.rows = 7;
  scene.winds.push_back({.velocity = {0, 0, 3}, .at = 0.0311, .duration = 0.05});
  scene.dt = 1e-3;
  for (const Precision precision : {Precision::Float, Precision::Double}) {
    scene.precision = precision;
    for (const Method& method : methods()) {
      if (!takes(method, scene)) continue;
      Simulation together(scene, method, {.threads = 2}), single(scene, method, {.threads = 1});
      together.tick(120);
      for (int k = 0; k < 120; ++k) single.tick();
      EXPECT_EQ(together.hash(), single.hash()) << method.name;
    }
  }
}

TEST(Air, GivesTheSameBitsAtEveryVectorLevel) {
  Scene scene = gustySheet();
  scene.columns = 21, scene.rows = 6;
  for (const Precision precision : {Precision::Float, Precision::Double}) {
    scene.precision = precision;
    std::vector<std::uint64_t> hashes;
    for (int level = 0; level <= int(bestVectorLevel()); ++level) {
      useVectorLevel(VectorLevel(level));
      Simulation simulation(scene, findMethod("leapfrog"), {.threads = 1});
      simulation.advanceTo(0.5);
      hashes.push_back(simulation.hash());
      EXPECT_EQ(hashes.back(), hashes.front()) << "level " << level;
    }
    useVectorLevel({});
  }
}

TEST(Air, IsInTheLedgerToTheOrderOfTheMethod) {
  const Scene scene = gustySheet();
  for (const auto& [name, most] : {std::pair{"rk4", 1e-6}, {"leapfrog", 1e-3}, {"symplectic-euler", 3e-2}}) {
    Scene timed = scene;
    timed.dt = 5e-3;
    Simulation simulation(timed, findMethod(name), {.ledger = true});
    simulation.advanceTo(2);
    EXPECT_LT(std::abs(simulation.ledger().drift), most) << name;
    EXPECT_GT(simulation.ledger().work["wind"], 0.1);
  }
}

TEST(Air, WithoutTheLedgerTheWorkOfTheWindIsEstimatedForTheAlarm) {
  Scene scene = gustySheet();
  scene.dt = 1e-3;
  Simulation exact(scene, findMethod("leapfrog"), {.ledger = true}), estimated(scene, findMethod("leapfrog"));
  exact.advanceTo(3), estimated.advanceTo(3);
  EXPECT_EQ(estimated.hash(), exact.hash());
  EXPECT_NEAR(estimated.ledger().work["wind"], exact.ledger().work["wind"], 0.03 * exact.ledger().work["wind"]);
  EXPECT_EQ(estimated.status(), Status::Ok);
}

TEST(Air, TheWorkOfTheWindIsCountedOnceWhereverTheLedgerIsFollowed) {
  Scene scene = gustySheet();
  scene.dt = 1e-3;
  for (const Method& method : methods()) {
    if (!takes(method, scene)) continue;
    Simulation exact(scene, method, {.ledger = true}), switched(scene, method);
    exact.tick(3000);
    switched.tick(700);
    const Snapshot early = switched.save();
    switched.followLedger(true);
    switched.tick(800);
    switched.followLedger(false);
    switched.tick(1500);
    const double work = exact.ledger().work["wind"];
    EXPECT_NEAR(switched.ledger().work["wind"], work, 0.03 * work) << method.name;
    // Back to where it was not followed, with the ledger followed since.
    switched.followLedger(true);
    switched.restore(early);
    switched.tick(2300);
    EXPECT_NEAR(switched.ledger().work["wind"], work, 0.03 * work) << method.name;
    EXPECT_EQ(switched.status(), Status::Ok) << method.name;
  }
}

TEST(Air, StopTimesOfWindsAreMetByEveryMethod) {
  Scene scene = gustySheet();
  scene.winds = {{.velocity = {0, 5, 0}, .at = 0.1 * std::sqrt(2.0), .duration = 0.1 * std::sqrt(3.0)}};
  scene.structural.ks = scene.shear.ks = scene.bend.ks = 0;
  scene.structural.kd = scene.shear.kd = scene.bend.kd = scene.drag = 0;
  scene.gravity = {};
  scene.pins.clear();
  scene.dt = 0.02;
  for (const Method& method : methods()) {
    if (!takes(method, scene)) continue;
    Simulation simulation(scene, method);
    simulation.advanceTo(scene.winds[0].at);
    for (int i = 0; i < simulation.sheet().count(); ++i) EXPECT_EQ(simulation.velocity(i), Vec3{}) << method.name;
    simulation.advanceTo(0.3);
    EXPECT_GT(simulation.velocity(4).y, 0) << method.name;
  }
}

TEST(Air, ImexRefusesItWithAReason) {
  EXPECT_FALSE(takes(findMethod("imex"), oneCell()));
  Scene still = oneCell();
  still.air.density = 0;
  Simulation simulation(still, findMethod("imex"));
  EXPECT_THROW(simulation.useLiveParameters(oneCell()), InputError);
  EXPECT_EQ(simulation.scene().air.density, 0);
}

}  // namespace
}  // namespace tyg::test

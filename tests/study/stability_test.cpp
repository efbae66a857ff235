// The step limit at rest against closed forms of the lattice's spectrum.
#include "study/limits/stability.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tyg/methods.h"

namespace tyg {
namespace {

constexpr double kClose = 1e-6;  // relative; the search stops at strides of 1e-4, and errs by their square

Scene cloth(double ks, double kh, double kb, int columns = 20, int rows = 20) {
  Scene scene;
  scene.columns = columns;
  scene.rows = rows;
  scene.particleMass = 0.018;
  scene.structural.ks = ks;
  scene.shear.ks = kh;
  scene.bend.ks = kb;
  return scene;
}

double limit(const Scene& scene, const char* method) { return unboundedLimit(scene, findMethod(method)); }

/// Undamped leapfrog is stable up to h w = 2, so its limit tells the largest m w^2.
double largestMassW2(const Scene& scene) {
  const double h = limit(scene, "leapfrog");
  return scene.particleMass * 4 / (h * h);
}

/// The largest m w^2 of an unbounded sheet at rest in closed form (docs/model.md, section 8).
double closedForm(double ks, double kh, double kb) {
  const double along = 4 * (kh + kb), both = ks + kh;
  const double first = ks <= along ? 2 * ks + along + (along > 0 ? ks * ks / along : 0) : 4 * ks;
  const double second = both <= 4 * kb ? 2 * both + 4 * kb + (kb > 0 ? both * both / (4 * kb) : 0) : 4 * both;
  return std::max(first, second);
}

TEST(UnboundedLimit, AgreesWithTheClosedFormOverRandomStiffnesses) {
  std::mt19937 random(20170705);
  std::uniform_real_distribution<double> exponent(0, 3);
  std::bernoulli_distribution absent(0.15);
  const auto stiffness = [&] { return absent(random) ? 0 : std::pow(10, exponent(random)); };
  for (int k = 0; k < 500; ++k) {
    const double ks = stiffness(), kh = stiffness(), kb = stiffness();
    if (ks + kh + kb == 0) continue;
    const double expected = closedForm(ks, kh, kb);
    EXPECT_NEAR(largestMassW2(cloth(ks, kh, kb)), expected, kClose * expected) << ks << " " << kh << " " << kb;
  }
}

TEST(UnboundedLimit, ALineOfParticlesHasTheSpectrumOfAChain) {
  for (const auto& [columns, rows] : {std::pair{1, 20}, {20, 1}}) {
    EXPECT_NEAR(largestMassW2(cloth(1000, 900, 0, columns, rows)), 4 * 1000, kClose * 4000);
  }
}

TEST(UnboundedLimit, FamiliesThatTheSheetHasNoRoomForDoNotCount) {
  EXPECT_DOUBLE_EQ(limit(cloth(1000, 0, 5000, 2, 2), "leapfrog"), limit(cloth(1000, 0, 0, 2, 2), "leapfrog"));
  EXPECT_DOUBLE_EQ(limit(cloth(1000, 5000, 0, 1, 9), "leapfrog"), limit(cloth(1000, 0, 0, 1, 9), "leapfrog"));
  EXPECT_LT(limit(cloth(1000, 0, 5000, 3, 2), "leapfrog"), limit(cloth(1000, 0, 0, 3, 2), "leapfrog"));
}

TEST(UnboundedLimit, UndampedRungeKuttaReachesItsPlaceOnTheImaginaryAxis) {
  const Scene scene = cloth(1200, 900, 200);
  const double w = std::sqrt(closedForm(1200, 900, 200) / scene.particleMass);
  EXPECT_NEAR(limit(scene, "rk4") * w, std::sqrt(8.0), kClose * 3);
}

TEST(UnboundedLimit, StrongRelativeDampingLimitsRungeKuttaByItsPureDampingModes) {
  Scene scene = cloth(1, 0, 0);
  scene.structural.kd = 10;
  const double largestD = 8 * scene.structural.kd / scene.particleMass;
  constexpr double kRealAxis = 2.785293563;  // |R| = 1 of the classical Runge-Kutta method on the real axis
  EXPECT_NEAR(limit(scene, "rk4") * largestD, kRealAxis, 1e-4);
}

TEST(UnboundedLimit, DampingShrinksLeapfrogsLimitByItsFormula) {
  Scene scene = cloth(1000, 0, 0, 1, 20);
  scene.structural.kd = 0.5;
  // The shortest wave is the stiffest and the most damped one: h^2 w2 + 4 h d = 4.
  const double w2 = 4 * 1000 / scene.particleMass, d = 4 * 0.5 / scene.particleMass;
  const double expected = (-2 * d + std::sqrt(4 * d * d + 4 * w2)) / w2;
  EXPECT_NEAR(limit(scene, "leapfrog"), expected, kClose * expected);
}

TEST(UnboundedLimit, AxialDampingIsNeverStrongerThanRelativeDamping) {
  Scene scene = cloth(1200, 900, 200);
  scene.structural.kd = scene.shear.kd = scene.bend.kd = 0.3;
  const double relative = limit(scene, "leapfrog");
  scene.damping = Damping::Axial;
  EXPECT_GT(limit(scene, "leapfrog"), relative);
  EXPECT_LT(limit(scene, "leapfrog"), limit(cloth(1200, 900, 200), "leapfrog"));
}

TEST(UnboundedLimit, ExplicitEulerHoldsOnlyWithDamping) {
  Scene scene = cloth(1200, 900, 200);
  EXPECT_EQ(limit(scene, "explicit-euler"), 0);
  scene.structural.kd = 0.1;
  EXPECT_GT(limit(scene, "explicit-euler"), 0);
}

TEST(UnboundedLimit, ThereIsNoneWhereNothingSetsOne) {
  EXPECT_TRUE(std::isnan(limit(cloth(0, 0, 0), "leapfrog")));
  EXPECT_TRUE(std::isnan(limit(cloth(1200, 900, 200, 1, 1), "rk4")));
  EXPECT_TRUE(std::isnan(limit(cloth(1200, 900, 200), "xpbd")));
}

}  // namespace
}  // namespace tyg

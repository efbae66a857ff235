// What makes a step hold: on the side that holds, and no more than needed; against all eigenvalues of random sheets.
#include "study/limits/holding_changes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/spectrum/rest_spectrum.h"
#include "study/limits/stability.h"
#include "test_systems.h"
#include "tyg/methods.h"

namespace tyg::test {
namespace {

Scene randomSheet(Numbers& numbers) {
  Scene scene = emptyWorld(int(numbers.between(2, 7)), int(numbers.between(2, 7)));
  scene.spacing = numbers.between(0.02, 0.2);
  scene.particleMass = numbers.between(0.001, 0.1);
  scene.structural = {numbers.between(10, 2000), 0};
  scene.shear = {numbers.between(0, 1) * scene.structural.ks, 0};
  if (numbers.coin()) scene.bend = {numbers.between(0, 0.5) * scene.structural.ks, 0};
  const double kd = numbers.between(0.001, 0.5) * std::sqrt(scene.structural.ks * scene.particleMass);
  for (SpringFamily* family : {&scene.structural, &scene.shear, &scene.bend}) family->kd = family->ks > 0 ? kd : 0;
  scene.damping = numbers.coin() ? Damping::Relative : Damping::Axial;
  return scene;
}

/// The smallest limit over all eigenvalues of the sheet at rest.
double limitOfEigenvalues(const Scene& scene, const Method& method) {
  const std::vector<std::complex<double>> roots = RestSpectrum(scene).roots();
  double fastest = 0, limit = std::numeric_limits<double>::infinity();
  for (const std::complex<double>& mu : roots) fastest = std::max(fastest, std::abs(mu));
  for (const std::complex<double>& mu : roots) {
    if (std::abs(mu) < 1e-5 * fastest) continue;
    const bool turns = std::abs(mu.imag()) > 1e-9 * std::abs(mu);
    limit =
        std::min(limit, turns ? method.stableStep(std::norm(mu), -2 * mu.real()) : method.stableStep(0, -mu.real()));
  }
  return limit;
}

TEST(HoldingChanges, HoldAndAreTheSmallest) {
  Numbers numbers(4);
  constexpr double kNear = 0.015;  // three digits, and the finite sheet's own margin
  int changed = 0;
  for (int round = 0; round < 6; ++round) {
    const Scene scene = randomSheet(numbers);
    for (const char* name : {"leapfrog", "rk4", "symplectic-euler"}) {
      const Method& method = findMethod(name);
      const double limit = restLatticeLimit(scene, method), dt = numbers.between(1.1, 4) * limit;
      ASSERT_FALSE(holdsAtRest(scene, method, dt));
      ASSERT_TRUE(holdsAtRest(scene, method, 0.999 * limit));
      const HoldingChanges changes = changesThatHold(scene, method, dt);
      EXPECT_LE(changes.dt, limit);
      EXPECT_GT(changes.dt, (1 - kNear) * limit);
      const auto check = [&](double factor, auto change) {
        if (std::isnan(factor)) return;
        Scene enough = scene, tooLittle = scene;
        change(enough, factor);
        change(tooLittle, std::pow(factor, 1 - kNear) * (factor > 1 ? 1 - kNear : 1 + kNear));
        EXPECT_GE(limitOfEigenvalues(enough, method), (1 - kNear) * dt) << name << " " << round << " " << factor;
        EXPECT_LT(restLatticeLimit(tooLittle, method), dt) << name << " " << round << " " << factor;
        ++changed;
      };
      check(changes.stiffness, [](Scene& s, double f) { s.structural.ks *= f, s.shear.ks *= f, s.bend.ks *= f; });
      check(changes.mass / scene.particleMass, [](Scene& s, double f) { s.particleMass *= f; });
      check(changes.damping / scene.structural.kd,
            [](Scene& s, double f) { s.structural.kd *= f, s.shear.kd *= f, s.bend.kd *= f; });
    }
  }
  EXPECT_GT(changed, 25);
}

TEST(HoldingChanges, WithoutDampingExplicitEulerIsToldHowMuchItNeeds) {
  Numbers numbers(9);
  Scene scene = randomSheet(numbers);
  for (SpringFamily* family : {&scene.structural, &scene.shear, &scene.bend}) family->kd = 0;
  scene.damping = Damping::Relative;
  const Method& method = findMethod("explicit-euler");
  const double dt = 0.02 * std::sqrt(scene.particleMass / scene.structural.ks);
  const HoldingChanges changes = changesThatHold(scene, method, dt);
  EXPECT_EQ(changes.dt, 0);
  EXPECT_TRUE(std::isnan(changes.mass));
  EXPECT_TRUE(std::isnan(changes.stiffness));
  ASSERT_GT(changes.damping, 0);
  for (SpringFamily* family : {&scene.structural, &scene.shear, &scene.bend}) {
    family->kd = family->ks > 0 ? changes.damping : 0;
  }
  EXPECT_TRUE(holdsAtRest(scene, method, dt));
}

TEST(HoldingChanges, TheSpringsThatLimitAreThoseWithoutWhichTheLimitIsAnother) {
  Scene scene = emptyWorld(40, 40);
  scene.structural.ks = 1000;
  scene.shear.ks = 700;
  scene.bend.ks = 100;  // of the wave with opposite neighbours both ends of a bend spring move alike
  EXPECT_EQ(springsThatLimit(scene, findMethod("rk4"), false), (std::vector<std::string>{"structural", "shear"}));
  EXPECT_TRUE(springsThatLimit(scene, findMethod("xpbd"), false).empty());
}

}  // namespace
}  // namespace tyg::test

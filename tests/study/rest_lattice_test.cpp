// The step limit of a sheet at rest against the closed form of its fastest wave.
#include <gtest/gtest.h>

#include <algorithm>
#include <span>

#include "scaled_scene.h"
#include "study/limits/stability.h"
#include "study/work/ladder.h"
#include "test_systems.h"
#include "tyg/methods.h"

namespace tyg::test {
namespace {

/// The largest m w^2 of an unbounded sheet: ks, kh, kb are the stiffnesses of structural, shear and bend springs.
double stiffest(double ks, double kh, double kb) {
  const auto crest = [](double k, double across) {
    return k <= 4 * across ? 2 * k + 4 * across + k * k / (4 * across) : 4 * k;
  };
  const double alongAxis = ks <= 4 * (kh + kb) ? crest(ks, kh + kb) : 4 * ks;
  const double diagonal = ks + kh <= 4 * kb ? 2 * (ks + kh) + 4 * kb + (ks + kh) * (ks + kh) / (4 * kb) : 4 * (ks + kh);
  return std::max(alongAxis, diagonal);
}

constexpr double kSearch = 1e-6;  // relative: the search over waves stops there

TEST(RestLattice, LimitsUndampedMethodsByItsFastestWave) {
  Numbers numbers(41);
  for (int draw = 0; draw < 50; ++draw) {
    Scene scene = emptyWorld(20, 20);
    scene.particleMass = numbers.between(0.01, 2);
    scene.structural.ks = numbers.between(1, 2000);
    scene.shear.ks = numbers.between(0, 2000);
    scene.bend.ks = numbers.between(0.001, 1000);
    const double fastest = std::sqrt(stiffest(scene.structural.ks, scene.shear.ks, scene.bend.ks) / scene.particleMass);
    const auto reach = [&](std::string_view name) { return restLatticeLimit(scene, findMethod(name)) * fastest; };
    ASSERT_NEAR(reach("symplectic-euler"), 2, 2 * kSearch);
    ASSERT_NEAR(reach("leapfrog"), 2, 2 * kSearch);
    ASSERT_NEAR(reach("rk4"), std::sqrt(8.0), 3 * kSearch);
    ASSERT_EQ(reach("explicit-euler"), 0);
  }
}

TEST(RestLattice, UnboundedOfOneRowIsAChain) {
  for (const bool upright : {false, true}) {
    Scene scene = upright ? emptyWorld(1, 20) : emptyWorld(20, 1);
    scene.structural.ks = 100;
    scene.shear.ks = 1e6;  // a single row has no shear springs
    EXPECT_NEAR(unboundedLimit(scene, findMethod("leapfrog")), 2 / std::sqrt(4 * 100.0), kSearch);
  }
}

TEST(RestLattice, StronglyDampedIsLimitedByItsWavesOutOfPlane) {
  Scene scene = emptyWorld(20, 20);
  scene.structural = {1, 10};
  scene.shear = {1, 5};
  // The largest h d of the relative law, all waves: structural 2 kd (2 - cx - cy) + shear 4 kd (1 - cx cy).
  double largest = 0;
  for (double cx = -1; cx <= 1; cx += 0.01) {
    for (double cy = -1; cy <= 1; cy += 0.01) largest = std::max(largest, 20 * (2 - cx - cy) + 20 * (1 - cx * cy));
  }
  EXPECT_NEAR(restLatticeLimit(scene, findMethod("rk4")) * largest, 2.7853, 1e-3);
}

TEST(RestLattice, WhoseFrequenciesOverflowLeavesNoStableStep) {
  Scene scene = emptyWorld(1, 2);
  scene.particleMass = 1e-300;
  scene.structural.ks = 1e300;
  for (const Method& method : methods()) {
    const double limit = restLatticeLimit(scene, method);
    const bool hasOne = method.stableStep != nullptr || method.stableStepOfScene != nullptr;
    EXPECT_TRUE(hasOne ? limit == 0 : std::isnan(limit)) << method.name << " " << limit;
  }
}

TEST(RestLattice, OfFreeFallSetsNoLimit) { EXPECT_TRUE(std::isnan(restLatticeLimit(freeFall(), findMethod("rk4")))); }

TEST(RestLattice, SetsTheSameLimitsAndLaddersInAnyUnits) {
  for (const char* name : {"spring", "wet"}) {
    for (const Damping law : {Damping::Relative, Damping::Axial}) {
      Scene scene = loadScene(name);
      scene.damping = law;
      scene.columns = std::min(scene.columns, 9);
      for (const Method& method : methods()) {
        const double expected = restLatticeLimit(scene, method);
        const std::size_t rungs = ladderOf(scene, method).size();
        for (const Units& units : std::span(kUnits).last(2)) {
          if (method.name == "report-rk4") continue;  // depends on the unit of time by its formula
          const Scene other = scaled(scene, units);
          const double found = restLatticeLimit(other, method) / units.time;
          EXPECT_TRUE(std::isnan(expected) ? std::isnan(found) : std::abs(found - expected) <= kSearch * expected)
              << name << " " << method.name << " " << found << " " << expected;
          EXPECT_NEAR(double(ladderOf(other, method).size()), double(rungs), 1) << name << " " << method.name;
          if (!(certifiedLimit(scene, method) > 0)) continue;
          EXPECT_NEAR(certifiedLimit(other, method) / certifiedLimit(scene, method) / units.time, 1, kSearch) << name;
        }
      }
    }
  }
}

}  // namespace
}  // namespace tyg::test

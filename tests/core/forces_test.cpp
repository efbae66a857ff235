// The forces against the oracle, against their own energy, and against the laws that any forces of this kind obey.
#include <gtest/gtest.h>

#include <limits>

#include "test_systems.h"

namespace tyg::test {
namespace {

struct Grid {
  int columns, rows;
};
// One particle, single rows and columns, sheets with no bend springs in one direction, and rows that end inside, at and
// beyond a vector's width.
constexpr Grid kGrids[] = {{1, 1}, {2, 1},  {1, 2},  {1, 9},  {23, 1}, {2, 2},
                           {3, 5}, {16, 3}, {17, 9}, {33, 2}, {40, 33}};
constexpr int kDraws = 12;  // random scenes per grid

// Each of a particle's up to 24 terms is a handful of rounded operations on numbers of that size.
constexpr double kRoundings = 16;

template <class T>
void expectTheOraclesForce(Bench<T>& bench) {
  const Oracle oracle(bench.scene);
  const Points at = bench.points();
  const std::vector<Vec3> expected = oracle.force(at), found = bench.force();
  const std::vector<double> magnitude = oracle.magnitude(at);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const double allowed = kRoundings * std::numeric_limits<T>::epsilon() * magnitude[i];
    ASSERT_LE(length(found[i] - expected[i]), allowed)
        << "particle " << i << " of " << bench.sheet.columns << "x" << bench.sheet.rows;
  }
}

template <class T>
void compareRandomScenes(double share) {
  Numbers numbers(7);
  for (const Grid& grid : kGrids) {
    for (int draw = 0; draw < kDraws; ++draw) {
      Bench<T> bench(randomScene(grid.columns, grid.rows, numbers));
      shake(bench, share, numbers);
      expectTheOraclesForce(bench);
    }
  }
}

TEST(Forces, EqualTheListOfSpringsInDoubleToRounding) { compareRandomScenes<double>(0.4); }
TEST(Forces, EqualTheListOfSpringsInFloatToRounding) { compareRandomScenes<float>(0.4); }
TEST(Forces, EqualTheListOfSpringsInACrumpledSheet) { compareRandomScenes<double>(5); }

TEST(Forces, OnASheetAtRestAreWeightAlone) {
  Scene scene = softSheet(Damping::Relative);
  scene.pins.clear();
  Bench<double> bench(scene);
  for (const Vec3& force : bench.force()) EXPECT_LE(length(force - scene.gravity), 1e-13);  // 1 kg each
}

TEST(Forces, AreMinusTheGradientOfTheEnergy) {
  constexpr double kStep = 1e-5;       // m: rounding of E / step and step^2 are then both near 1e-9
  constexpr double kTolerance = 1e-7;  // of the largest force
  Numbers numbers(3);
  for (const Grid& grid : {Grid{2, 2}, Grid{5, 4}, Grid{1, 6}}) {
    Scene scene = randomScene(grid.columns, grid.rows, numbers);
    scene.structural.ks = 100, scene.shear.ks = 70, scene.bend.ks = 30, scene.drag = 0, scene.pins.clear();
    Bench<double> bench(scene);
    shake(bench, 0.3, numbers);
    bench.state.velocity = VectorField<double>(bench.forces.layout());
    const std::vector<Vec3> force = bench.force();
    const auto energyAt = [&](int particle, const Vec3& position) {
      State<double> state = bench.state;
      state.position.set(particle, position);
      const StoredEnergy energy = bench.forces.energy(0, state);
      return energy.sum() - energy.kinetic;
    };
    for (int i = 0; i < bench.sheet.count(); ++i) {
      for (const Vec3& along : {Vec3{kStep, 0, 0}, Vec3{0, kStep, 0}, Vec3{0, 0, kStep}}) {
        const Vec3 here = bench.state.position.get(i);
        const double slope = (energyAt(i, here + along) - energyAt(i, here - along)) / (2 * kStep);
        EXPECT_NEAR(dot(force[std::size_t(i)], along) / kStep, -slope, kTolerance * 100 * scene.spacing);
      }
    }
  }
}

TEST(Forces, ElasticAndKineticEnergyEqualTheListOfSprings) {
  Numbers numbers(11);
  for (const Grid& grid : kGrids) {
    Bench<double> bench(randomScene(grid.columns, grid.rows, numbers));
    shake(bench, 0.3, numbers);
    const Points at = bench.points();
    double kinetic = 0;
    for (const Vec3& v : at.v) kinetic += bench.scene.particleMass * dot(v, v) / 2;
    const StoredEnergy energy = bench.forces.energy(0, bench.state);
    const double elastic = energy.of<StructuralSprings>();
    EXPECT_NEAR(elastic, Oracle(bench.scene).elastic(at), 1e-12 * elastic);
    EXPECT_NEAR(energy.kinetic, kinetic, 1e-12 * kinetic);
  }
}

/// A sheet on which nothing acts but its own springs.
Scene isolatedScene(Damping damping, double kd) {
  Scene scene = emptyWorld(6, 5);
  scene.damping = damping;
  scene.structural = {100, kd};
  scene.shear = {60, kd};
  scene.bend = {30, kd};
  return scene;
}

Vec3 sumOf(const std::vector<Vec3>& all) {
  Vec3 sum;
  for (const Vec3& one : all) sum = sum + one;
  return sum;
}

Vec3 torque(const Points& at, const std::vector<Vec3>& force) {
  Vec3 sum;
  for (std::size_t i = 0; i < force.size(); ++i) sum = sum + cross(at.x[i], force[i]);
  return sum;
}

constexpr double kBalance = 1e-11;  // N, N m: 30 particles, forces of some 100 N, arms of some metres

TEST(Forces, OfSpringsSumToZero) {
  for (const Damping damping : {Damping::Relative, Damping::Axial}) {
    Bench<double> bench(isolatedScene(damping, 2));
    Numbers numbers(5);
    shake(bench, 0.3, numbers);
    EXPECT_LE(length(sumOf(bench.force())), kBalance);
  }
}

TEST(Forces, OfAxialDampingTurnNothing) {
  Bench<double> bench(isolatedScene(Damping::Axial, 2));
  Numbers numbers(5);
  shake(bench, 0.3, numbers);
  EXPECT_LE(length(torque(bench.points(), bench.force())), kBalance);
}

TEST(Forces, OfRelativeDampingSlowARigidRotation) {
  for (const Damping damping : {Damping::Relative, Damping::Axial}) {
    Bench<double> bench(isolatedScene(damping, 2));
    const Vec3 spin{0, 0, 1.5};
    for (int i = 0; i < bench.sheet.count(); ++i) bench.state.velocity.set(i, cross(spin, bench.state.position.get(i)));
    const double turning = torque(bench.points(), bench.force()).z;
    if (damping == Damping::Relative) {
      EXPECT_LT(turning, -1);
    } else {
      EXPECT_NEAR(turning, 0, kBalance);
    }
  }
}

TEST(Forces, OfCoincidentParticlesAreTheDampingAlone) {
  for (const Damping damping : {Damping::Relative, Damping::Axial}) {
    Bench<double> bench(isolatedScene(damping, 2));
    Numbers numbers(9);
    for (int i = 0; i < bench.sheet.count(); ++i) {
      bench.state.position.set(i, {0.3, 0.4, 0.5});
      bench.state.velocity.set(i, numbers.inCube(1));
    }
    expectTheOraclesForce(bench);
  }
}

TEST(Forces, OfNearlyCoincidentParticlesAreFinite) {
  for (const double apart : {1e-5, 1e-12, 1e-19, 1e-23, 1e-38}) {
    Bench<float> bench(isolatedScene(Damping::Axial, 2));
    for (int i = 0; i < bench.sheet.count(); ++i) {
      bench.state.position.set(i, {apart * i, 0, 0});
      bench.state.velocity.set(i, {0, double(i), 0});
    }
    for (const Vec3& force : bench.force()) EXPECT_TRUE(std::isfinite(length(force))) << "apart " << apart;
  }
}

TEST(Forces, OnAPinnedParticleAreExactlyZero) {
  Scene scene = softSheet(Damping::Relative);
  scene.pins = {{"corners"}, {"middle"}};
  Bench<double> bench(scene);
  Numbers numbers(2);
  shake(bench, 0.3, numbers);
  ASSERT_EQ(bench.sheet.pins.size(), 5U);
  for (const int pin : bench.sheet.pins) bench.forces.addPush(pin, {1, 2, 3});
  const std::vector<Vec3> force = bench.force();
  for (const int pin : bench.sheet.pins) EXPECT_EQ(force[std::size_t(pin)], Vec3{});
}

TEST(Forces, OfPushesAddUpAndEnd) {
  Bench<double> bench(emptyWorld(3, 3));
  bench.forces.addPush(4, {1, 0, 0});
  bench.forces.addPush(4, {0.5, 2, 0});
  bench.forces.addPush(8, {0, 0, -3});
  const std::vector<Vec3> force = bench.force();
  EXPECT_EQ(force[4], (Vec3{1.5, 2, 0}));
  EXPECT_EQ(force[8], (Vec3{0, 0, -3}));
  EXPECT_EQ(sumOf(force), (Vec3{1.5, 2, -3}));
  bench.forces.clearPushes();
  EXPECT_EQ(sumOf(bench.force()), Vec3{});
}

TEST(Forces, AreTheSameBitsForAnyNumberOfThreads) {
  for (const Grid& grid : kGrids) {
    std::vector<std::vector<Vec3>> results;
    for (const int threads : {1, 2, 3, 5}) {
      Numbers numbers(13);
      Scene scene = randomScene(grid.columns, grid.rows, numbers);
      scene.structural = {100, 1};
      Bench<float> bench(scene, threads);
      shake(bench, 0.4, numbers);
      results.push_back(bench.force());
    }
    for (const auto& result : results) EXPECT_EQ(result, results.front()) << grid.columns << "x" << grid.rows;
  }
}

TEST(Forces, CountTheirEvaluations) {
  Bench<double> bench(softSheet(Damping::Axial));
  EXPECT_EQ(bench.forces.evaluations(), 0);
  for (int i = 0; i < 3; ++i) bench.force();
  EXPECT_EQ(bench.forces.evaluations(), 3);
  EXPECT_EQ(bench.forces.energy(0, bench.state).kinetic, 0);
  EXPECT_EQ(bench.forces.evaluations(), 3) << "looking at energies is free";
}

TEST(Forces, ReportThePowerThatDampingAndDragTake) {
  for (const Damping damping : {Damping::Relative, Damping::Axial}) {
    Scene scene = softSheet(damping);
    scene.pins.clear();
    Bench<double> bench(scene);
    Numbers numbers(17);
    shake(bench, 0.3, numbers);
    Scene lossless = scene;
    lossless.structural.kd = lossless.shear.kd = lossless.bend.kd = lossless.drag = 0;
    const Points at = bench.points();
    const std::vector<Vec3> all = Oracle(scene).force(at), kept = Oracle(lossless).force(at);
    double taken = 0;
    for (std::size_t i = 0; i < all.size(); ++i) taken += dot(kept[i] - all[i], at.v[i]);
    bench.forces.trackDissipation(true);
    bench.force();
    EXPECT_NEAR(bench.forces.power().lost, taken, 1e-12 * taken);
  }
}

}  // namespace
}  // namespace tyg::test

// The step limit of the present state against dense eigenvalues of the forces' Jacobian, which the oracle differences.
#include "core/spectrum/live_spectrum.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "test_systems.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg::test {
namespace {

constexpr double kSettled = 0.015;  // after ten calls
constexpr double kFirst = 0.1;      // of the first one, which starts from a wave of the flat sheet
constexpr double kSafeSide = 1e-3;  // a mode's quotient never exceeds the largest: what is below is the differences'
constexpr int kCalls = 10;

using Dense = Eigen::MatrixXd;
struct Jacobian {
  Dense K, C;  // -da/dx, -da/dv
};

double& component(Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

Jacobian jacobianOf(const Scene& scene, const Simulation& simulation, const std::vector<CutLine>& cuts = {}) {
  Points here;
  for (int i = 0; i < simulation.sheet().count(); ++i) {
    here.x.push_back(simulation.position(i));
    here.v.push_back(simulation.velocity(i));
  }
  Oracle oracle(scene);
  for (const CutLine& cut : cuts) oracle.cut(cut);
  const auto count = Eigen::Index(here.x.size());
  const double e = 1e-6 * scene.spacing;
  const auto differences = [&](std::vector<Vec3> Points::*of) {
    Dense matrix = Dense::Zero(3 * count, 3 * count);
    for (Eigen::Index k = 0; k < 3 * count; ++k) {
      if (oracle.pinned(std::size_t(k / 3))) continue;
      Points up = here, down = here;
      component((up.*of)[std::size_t(k / 3)], int(k % 3)) += e;
      component((down.*of)[std::size_t(k / 3)], int(k % 3)) -= e;
      const std::vector<Vec3> above = oracle.force(up), below = oracle.force(down);
      for (Eigen::Index i = 0; i < 3 * count; ++i) {
        Vec3 change = below[std::size_t(i / 3)] - above[std::size_t(i / 3)];
        matrix(i, k) = component(change, int(i % 3)) / (2 * e * scene.particleMass);
      }
    }
    return matrix;
  };
  return {differences(&Points::x), differences(&Points::v)};
}

/// The h at which the largest eigenvalue of h^2 K + c h C is 4.
double limitOf(const Jacobian& jacobian, double c) {
  double h = 1e-3;
  for (int k = 0; k < 8; ++k) {
    const Dense all = h * h * jacobian.K + c * h * jacobian.C;
    const Eigen::SelfAdjointEigenSolver<Dense> eigen((all + all.transpose()) / 2, Eigen::EigenvaluesOnly);
    h *= std::sqrt(4 / eigen.eigenvalues().cwiseAbs().maxCoeff());
  }
  return h;
}

/// A sheet pulled out of shape: stretched by up to half, every particle shaken besides.
Scene stretchedSheet(Numbers& numbers) {
  Scene scene = emptyWorld(int(numbers.between(3, 7)), int(numbers.between(4, 7)));
  scene.start = numbers.coin() ? Start::Flat : Start::Hanging;
  scene.damping = numbers.coin() ? Damping::Relative : Damping::Axial;
  scene.structural = {numbers.between(100, 2000), numbers.between(0, 2)};
  scene.shear = {numbers.between(10, 1000), numbers.between(0, 1)};
  scene.bend = {numbers.between(10, 500), numbers.between(0, 1)};
  scene.pins = {{"top-left"}, {"bottom-right"}};
  const Sheet sheet = makeSheet(scene);
  const double stretch = numbers.between(0, 0.5);
  for (int i = 0; i < sheet.count(); ++i) {
    const Place place{"", i % scene.columns, i / scene.columns};
    scene.displacements.push_back({place, stretch * sheet.startPosition(i) + numbers.inCube(0.1)});
  }
  scene.dt = 1e-3;
  return scene;
}

struct Named {
  const char* method;
  double c;
};

TEST(LiveStableStep, AgreesWithDenseEigenvaluesOfStretchedSheets) {
  Numbers numbers(7);
  for (int draw = 0; draw < 8; ++draw) {
    const Scene scene = stretchedSheet(numbers);
    for (const auto& [name, c] : {Named{"symplectic-euler", 2}, {"leapfrog", 4}}) {
      Simulation simulation(scene, findMethod(name));
      const double exact = limitOf(jacobianOf(scene, simulation), c);
      double limit = simulation.liveStableStep();
      EXPECT_NEAR(limit / exact, 1, kFirst) << name << " " << draw;
      for (int call = 1; call < kCalls; ++call) limit = simulation.liveStableStep();
      EXPECT_NEAR(limit / exact, 1, kSettled) << name << " " << draw;
      EXPECT_GT(limit / exact, 1 - kSafeSide) << name << " " << draw;
    }
  }
}

TEST(LiveStableStep, AfterRandomCutsAgreesWithDenseEigenvalues) {
  Numbers numbers(17);
  for (int draw = 0; draw < 8; ++draw) {
    const Scene scene = stretchedSheet(numbers);
    for (const auto& [name, c] : {Named{"symplectic-euler", 2}, {"leapfrog", 4}}) {
      Simulation simulation(scene, findMethod(name));
      simulation.liveStableStep();  // what it has learned of the whole sheet must not stay
      std::vector<CutLine> cuts;
      for (int k = 0; k < 3; ++k) {
        const auto place = [&](int count) { return numbers.between(-1, count); };
        cuts.push_back({place(scene.columns), place(scene.rows), place(scene.columns), place(scene.rows)});
        simulation.cut(cuts.back());
      }
      const double exact = limitOf(jacobianOf(scene, simulation, cuts), c);
      double limit = 0;
      for (int call = 0; call < 2 * kCalls; ++call) limit = simulation.liveStableStep();
      EXPECT_NEAR(limit / exact, 1, kSettled) << name << " " << draw;
      EXPECT_GT(limit / exact, 1 - kSafeSide) << name << " " << draw;
    }
  }
}

TEST(LiveStableStep, FollowsAMovingSheetInBothPrecisions) {
  Scene scene = withSheet(loadScene("curtain"), 7, 6);
  scene.dt = 2e-4;
  scene.pushes = {{{"middle"}, {0, 0, 10}, 0.1, 0.2}};
  for (const Precision precision : {Precision::Float, Precision::Double}) {
    scene.precision = precision;
    Simulation simulation(scene, findMethod("leapfrog"));
    for (int frame = 0; frame < 30; ++frame) {
      const double limit = simulation.liveStableStep();
      if (frame % 6 == 0) {
        const double exact = limitOf(jacobianOf(scene, simulation), 4);
        ASSERT_NEAR(limit / exact, 1, frame == 0 ? kFirst : kSettled) << frame;
      }
      simulation.advanceTo((frame + 1) / 60.0);
    }
  }
}

TEST(LiveStableStep, TakesRungeKuttasLimitFromStiffnessOrDampingWhicheverRules) {
  Scene scene = withSheet(loadScene("curtain"), 7, 6);
  for (const double kd : {0.0, 5.0}) {
    scene.structural.kd = scene.shear.kd = scene.bend.kd = kd;
    Simulation simulation(scene, findMethod("rk4"));
    const Jacobian jacobian = jacobianOf(scene, simulation);
    const auto largest = [](const Dense& matrix) {
      return Eigen::SelfAdjointEigenSolver<Dense>(matrix, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
    };
    const double exact = kd == 0 ? 2.828427 / std::sqrt(largest(jacobian.K)) : 2.785294 / largest(jacobian.C);
    for (int call = 0; call < 3 * kCalls; ++call) (void)simulation.liveStableStep();
    EXPECT_NEAR(simulation.liveStableStep() / exact, 1, kSettled) << kd;
  }
}

TEST(LiveStableStep, ShrinksWhereTheSheetIsStretchedFarAndTheRestLatticeDoesNotTell) {
  Scene scene = emptyWorld(6, 6);
  scene.structural.ks = scene.shear.ks = 1000;
  Simulation atRest(scene, findMethod("leapfrog"));
  const Sheet sheet = makeSheet(scene);
  for (int i = 0; i < sheet.count(); ++i) {
    scene.displacements.push_back({{"", i % 6, i / 6}, 0.6 * sheet.startPosition(i)});
  }
  Simulation stretched(scene, findMethod("leapfrog"));
  for (int call = 0; call < kCalls; ++call) {
    (void)atRest.liveStableStep();
    (void)stretched.liveStableStep();
  }
  EXPECT_LT(stretched.liveStableStep(), 0.97 * atRest.liveStableStep());
}

TEST(LiveStableStep, ChangesNeitherTheMotionNorItsCounts) {
  Scene scene = loadScene("poke");
  scene.duration = 0.7;
  for (const Method& method : methods()) {
    Simulation alone(scene, method), watched(scene, method);
    for (int frame = 1; frame <= 7; ++frame) {
      alone.advanceTo(0.1 * frame);
      watched.advanceTo(0.1 * frame);
      (void)watched.liveStableStep();
    }
    EXPECT_EQ(alone.hash(), watched.hash()) << method.name;
    EXPECT_EQ(alone.forceEvaluations(), watched.forceEvaluations()) << method.name;
  }
}

TEST(LiveStableStep, TakesFourForceEvaluationsOrFewer) {
  Bench<double> bench(loadScene("curtain"));
  for (const Method& method : methods()) {
    LiveSpectrum<double> spectrum(bench.scene, bench.sheet, bench.workers);
    for (int call = 1; call <= 3; ++call) {
      (void)spectrum.stableStep(method, bench.state, 0);
      EXPECT_LE(spectrum.evaluations(), 4 * call) << method.name;
    }
  }
}

TEST(LiveStableStep, IsInfiniteWhereNothingSetsOneAndNotANumberWhereTheMethodHasNone) {
  EXPECT_EQ(Simulation(freeFall(), findMethod("rk4")).liveStableStep(), std::numeric_limits<double>::infinity());
  const Scene scene = loadScene("curtain");
  for (const char* name : {"xpbd", "backward-euler", "rkc2"}) {
    EXPECT_TRUE(std::isnan(Simulation(scene, findMethod(name)).liveStableStep())) << name;
  }
}

TEST(LiveStableStep, OfAnUndampedSheetIsNothingForExplicitEuler) {
  Scene scene = emptyWorld(4, 4);
  scene.structural.ks = 100;
  EXPECT_EQ(Simulation(scene, findMethod("explicit-euler")).liveStableStep(), 0);
}

TEST(LiveStableStep, ComesBackAfterAStateThatWasNotFinite) {
  Bench<double> bench(loadScene("curtain"));
  LiveSpectrum<double> spectrum(bench.scene, bench.sheet, bench.workers);
  const Method& method = findMethod("leapfrog");
  const double before = spectrum.stableStep(method, bench.state, 0);
  State<double> broken = bench.state;
  broken.position.set(25, {std::numeric_limits<double>::quiet_NaN(), 0, 0});
  EXPECT_TRUE(std::isnan(spectrum.stableStep(method, broken, 0)));
  EXPECT_NEAR(spectrum.stableStep(method, bench.state, 0) / before, 1, kFirst);
}

}  // namespace
}  // namespace tyg::test

// The step limit of the present state of a sheet that rests on a body, against dense eigenvalues of differences of its
// forces.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "core/spectrum/live_spectrum.h"
#include "test_systems.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg::test {
namespace {

constexpr double kSettled = 0.015;  // as without contact
constexpr int kCalls = 10;

using Dense = Eigen::MatrixXd;

/// A sheet that lies on a floor, some particles of it deep in the layer and some just at its top, and a ball in it.
Scene resting(double stiffness) {
  Scene scene = emptyWorld(6, 5);
  scene.start = Start::Flat;
  scene.structural = {300, 0.3}, scene.shear = {200, 0.2}, scene.bend = {40, 0.1};
  scene.bodies = {{.shape = Shape::Plane, .at = {0, 0.02, 0}},
                  {.shape = Shape::Ball, .at = {2.2, -1.46, 2.1}, .radius = 1.5}};
  scene.contact = {.stiffness = stiffness, .layer = 0.02, .gap = 0};
  fillContact(scene);
  Numbers numbers(3);
  for (int i = 0; i < 30; ++i) {
    scene.displacements.push_back({{"", i % 6, i / 6}, {0, numbers.between(-0.03, 0.03), 0}});
  }
  scene.dt = 1e-3;
  return scene;
}

/// -da/dx or -da/dv by differences.
Dense derivative(const Scene& scene, const Points& here, std::vector<Vec3> Points::*of) {
  Bench<double> bench(scene);
  const auto count = Eigen::Index(here.x.size());
  constexpr double kReach = 1e-7;  // m, and m/s
  Dense matrix = Dense::Zero(3 * count, 3 * count);
  for (Eigen::Index k = 0; k < 3 * count; ++k) {
    const auto forceAt = [&](double by) {
      Points moved = here;
      Vec3& v = (moved.*of)[std::size_t(k / 3)];
      (k % 3 == 0 ? v.x : k % 3 == 1 ? v.y : v.z) += by;
      bench.set(moved);
      return bench.force();
    };
    const std::vector<Vec3> above = forceAt(kReach), below = forceAt(-kReach);
    for (Eigen::Index i = 0; i < 3 * count; ++i) {
      const Vec3 change = below[std::size_t(i / 3)] - above[std::size_t(i / 3)];
      const double along = i % 3 == 0 ? change.x : i % 3 == 1 ? change.y : change.z;
      matrix(i, k) = along / (2 * kReach * scene.particleMass);
    }
  }
  return matrix;
}

/// The h at which the largest eigenvalue of h^2 K + c h C is 4.
double exactLimit(const Scene& scene, const Simulation& simulation, double c) {
  Points here;
  for (int i = 0; i < simulation.sheet().count(); ++i) {
    here.x.push_back(simulation.position(i)), here.v.push_back(simulation.velocity(i));
  }
  const Dense K = derivative(scene, here, &Points::x), C = derivative(scene, here, &Points::v);
  double h = 1e-3;
  for (int k = 0; k < 8; ++k) {
    const Dense all = h * h * K + c * h * C;
    const Eigen::SelfAdjointEigenSolver<Dense> eigen((all + all.transpose()) / 2, Eigen::EigenvaluesOnly);
    h *= std::sqrt(4 / eigen.eigenvalues().cwiseAbs().maxCoeff());
  }
  return h;
}

TEST(LiveStableStep, OfASheetThatLiesOnBodiesAgreesWithDenseEigenvalues) {
  for (const double stiffness : {100.0, 1000.0, 20000.0}) {
    const Scene scene = resting(stiffness);
    for (const auto& [name, c] : {std::pair{"symplectic-euler", 2.0}, {"leapfrog", 4.0}}) {
      Simulation simulation(scene, findMethod(name));
      const double exact = exactLimit(scene, simulation, c);
      double limit = 0;
      for (int call = 0; call < 2 * kCalls; ++call) limit = simulation.liveStableStep();
      EXPECT_NEAR(limit / exact, 1, kSettled) << name << " " << stiffness;
    }
  }
}

TEST(LiveStableStep, OfAStiffContactIsShorterThanThatOfTheSpringsAndEndsWithIt) {
  Scene scene = resting(20000);
  const auto limitOf = [](const Scene& of) {
    Simulation simulation(of, findMethod("leapfrog"));
    double limit = 0;
    for (int call = 0; call < kCalls; ++call) limit = simulation.liveStableStep();
    return limit;
  };
  const double touching = limitOf(scene);
  for (Body& body : scene.bodies) body.at.y -= 1;
  const double above = limitOf(scene);
  scene.bodies.clear(), scene.contact = {};
  EXPECT_LT(touching, 0.5 * above);
  EXPECT_NEAR(above / limitOf(scene), 1, kSettled) << "bodies that nothing touches do not count";
}

TEST(LiveStableStep, CountsFrictionAndTheExplicitDampingOfContactWhereAParticleTouches) {
  Scene scene = resting(20000);
  scene.contact.friction = 1, scene.contact.grip = 500;
  scene.contact.damping = 2;
  const auto limitOf = [](const Scene& of, const char* name) {
    Simulation simulation(of, findMethod(name));
    double limit = 0;
    for (int call = 0; call < kCalls; ++call) limit = simulation.liveStableStep();
    return limit;
  };
  const double grip = 500 / scene.particleMass;
  EXPECT_LE(limitOf(scene, "symplectic-euler"), 2 / grip * (1 + 1e-9));
  const Method& imex = findMethod("imex");
  const double mass = scene.particleMass, damping = 4 * std::sqrt(20000 * mass);
  EXPECT_LE(limitOf(scene, "imex"), imex.stableStepWhereHeld(20000 / mass, damping / mass) * (1 + 1e-9));
  EXPECT_LE(limitOf(scene, "imex"), imex.stableStepWhereHeld(0, grip) * (1 + 1e-9));
}

}  // namespace
}  // namespace tyg::test

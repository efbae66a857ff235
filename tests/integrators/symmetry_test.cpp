// Symmetries that the equations have and that every method must keep.
#include <gtest/gtest.h>

#include "method_checks.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg::test {
namespace {

constexpr double kRounding = 1e-11;  // m, grown from the last bit over a second of soft cloth
constexpr double kSolved = 1e-7;     // the same for a method that ends its linear solve at a residual

double roundingOf(const Method& method) { return method.name == "backward-euler" ? kSolved : kRounding; }

TEST(Symmetry, AMirroredSceneMovesAsTheMirrorImage) {
  for (const Method& method : methods()) {
    if (method.name == "xpbd") continue;  // sweeps over the springs in index order, which no mirror keeps
    EXPECT_LE(mirrorError(method), roundingOf(method)) << method.name;
  }
}

TEST(Symmetry, MotionInAPlaneStaysInItExactly) {
  Scene scene = softSheet(Damping::Relative);
  scene.start = Start::Hanging;
  scene.gravity = {0.5, -3, 0};
  scene.displacements = {{{"bottom-left"}, {0.3, 0, 0}}};
  scene.tolerance = 1e-5;
  for (const Method& method : methods()) {
    Simulation simulation(scene, method);
    simulation.advanceTo(1);
    for (int i = 0; i < simulation.sheet().count(); ++i) {
      EXPECT_EQ(simulation.position(i).z, 0) << method.name;
      EXPECT_EQ(simulation.velocity(i).z, 0) << method.name;
    }
  }
}

TEST(Symmetry, PinnedParticlesKeepTheirStartExactly) {
  Scene scene = lopsided();
  scene.pushes[0].particle = scene.pins[1];
  for (const Method& method : methods()) {
    Simulation simulation(scene, method);
    simulation.advanceTo(1);
    for (const int pin : simulation.sheet().pins) {
      EXPECT_EQ(simulation.position(pin), simulation.sheet().startPosition(pin)) << method.name;
      EXPECT_EQ(simulation.velocity(pin), Vec3{}) << method.name;
    }
  }
}

/// A tumbling sheet that nothing holds.
Points tumbling(const Bench<double>& bench) {
  Numbers numbers(31);
  Points at = bench.points();
  for (std::size_t i = 0; i < at.x.size(); ++i) {
    at.v[i] = cross(Vec3{0.5, 1, -0.7}, at.x[i]) + numbers.inCube(0.3) + Vec3{1, 2, 3};
  }
  return at;
}

TEST(Symmetry, AFreeSheetKeepsItsMomentumWithEveryMethod) {
  for (const Damping damping : {Damping::Relative, Damping::Axial}) {
    Scene scene = softSheet(damping);
    scene.pins.clear();
    scene.gravity = {};
    scene.drag = 0;
    for (const Method& method : methods()) {
      if (damping == Damping::Axial && method.name == "imex") continue;  // refuses the axial law
      Bench<double> bench(scene);
      bench.set(tumbling(bench));
      const auto momentum = [&] {
        Vec3 sum;
        for (const Vec3& v : bench.points().v) sum = sum + v;
        return sum;
      };
      const Vec3 before = momentum();
      bench.advance(method, 1, 200);
      EXPECT_LE(length(momentum() - before), roundingOf(method)) << method.name;
    }
  }
}

TEST(Symmetry, AxialDampingKeepsTheAngularMomentumToTheOrderOfTheMethod) {
  Scene scene = softSheet(Damping::Axial);
  scene.pins.clear();
  scene.gravity = {};
  scene.drag = 0;
  for (const std::string_view name : {"symplectic-euler", "leapfrog", "rk4"}) {
    Bench<double> bench(scene);
    bench.set(tumbling(bench));
    const auto turning = [&] {
      const Points at = bench.points();
      Vec3 sum;
      for (std::size_t i = 0; i < at.x.size(); ++i) sum = sum + cross(at.x[i], at.v[i]);
      return sum;
    };
    const Vec3 before = turning();
    bench.advance(findMethod(name), 1, 200);
    // A kick along the springs and a drift along the velocity turn nothing; leapfrog's damping and rk4's mixed stages
    // do.
    const double allowed = name == "symplectic-euler" ? kRounding : name == "leapfrog" ? 1e-3 : 1e-7;
    EXPECT_LE(length(turning() - before), allowed * length(before)) << name;
  }
}

}  // namespace
}  // namespace tyg::test

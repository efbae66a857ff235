// Contact with bodies: closed forms of one particle, of a rope and of a sheet, and a reference written from the model.
#include "contact_reference.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg::test {
namespace {

constexpr double kGravity = 9.81;

TEST(Contact, AParticleAtRestIsAsDeepAsItsWeightPressesIt) {
  for (const bool deep : {false, true}) {
    Scene scene = particleOnFloor();
    scene.contact.damping = 0.5, scene.dt = 2e-4;
    if (deep) scene.contact.stiffness = 10, scene.contact.layer = 0.002;
    const double weight = scene.particleMass * kGravity, depth = depthOfPush(scene.contact, weight);
    if (deep) {
      EXPECT_NEAR(depth, weight / scene.contact.stiffness + scene.contact.layer / 2, 1e-12);
    }
    for (const Method& method : methods()) {
      Simulation simulation(scene, method);
      simulation.advanceTo(4);
      // XPBD's compliance is that of the deepest place of the layer.
      const double most = method.name == "xpbd" && !deep ? 1e-3 * depth : 1e-6 * depth;
      EXPECT_NEAR(simulation.position(0).y, -depth, most) << method.name << " " << deep;
    }
  }
}

/// The time from one highest point to the next of a particle that falls `height` on to an undamped floor.
double periodOfBounce(const Scene& scene, double height) {
  const Contact& c = scene.contact;
  const double perMass = 1 / scene.particleMass;
  // v^2 at a depth, with the energy of the highest point
  const auto squared = [&](double depth) {
    return 2 * (kGravity * (height + depth) - perMass * c.stiffness * c.layer * c.layer * energyShare(depth / c.layer));
  };
  double low = 0, high = 1;
  for (int k = 0; k < 200; ++k) (squared((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
  // depth = deepest (1 - s^2) takes the root's singularity away
  constexpr int kIntervals = 20000;
  double down = 0;
  for (int k = 0; k < kIntervals; ++k) {
    const double s = (k + 0.5) / kIntervals;
    down += 2 * low * s / std::sqrt(squared(low * (1 - s * s))) / kIntervals;
  }
  return 2 * std::sqrt(2 * height / kGravity) + 2 * down;
}

TEST(Contact, WithoutDampingAParticleBouncesToItsHeightInThePeriodOfTheQuadrature) {
  constexpr double kHeight = 0.05;
  Scene scene = particleOnFloor();
  scene.contact.damping = 0;
  scene.bodies[0].at.y = -kHeight;
  const double period = periodOfBounce(scene, kHeight);
  for (const auto& [name, step, most] : {std::tuple{"rk4", 1e-4, 1e-7},
                                         {"dopri54", 1e-4, 1e-6},
                                         {"bs32", 1e-4, 1e-5},
                                         {"leapfrog", 1e-4, 1e-5},
                                         {"imex", 1e-4, 1e-5},
                                         {"symplectic-euler", 2e-5, 1e-4}}) {
    scene.dt = step, scene.tolerance = 1e-9;
    Simulation simulation(scene, findMethod(name), {.ledger = true});
    simulation.advanceTo(period);
    EXPECT_NEAR(simulation.position(0).y, 0, most) << name;
    EXPECT_NEAR(simulation.velocity(0).y, 0, 100 * most) << name;
    const Ledger ledger = simulation.ledger();
    EXPECT_EQ(ledger.dissipated, 0) << name;
    EXPECT_NEAR(ledger.mechanical(), 0, 10 * most * scene.particleMass * kGravity * kHeight) << name;
  }
}

/// A particle on a slope of angle a (tan a = 0.75), as deep as it rests.
Scene onSlope(double friction) {
  Scene scene = particleOnFloor();
  scene.contact.friction = friction;
  scene.bodies[0].normal = {0.6, 0.8, 0};
  const double depth = depthOfPush(scene.contact, scene.particleMass * kGravity * 0.8);
  scene.displacements = {{{"top-left"}, -depth * scene.bodies[0].normal}};
  return scene;
}

TEST(Contact, FrictionHoldsOnASlopeButForACreep) {
  const Scene scene = onSlope(1.0);
  const double slow = scene.contact.friction * scene.particleMass * kGravity * 0.8 / scene.contact.grip;
  const double creep = slow * 0.75 / std::sqrt(1 - 0.75 * 0.75);
  for (const Method& method : methods()) {
    Simulation simulation(scene, method);
    simulation.advanceTo(2);
    const double speed = dot(simulation.velocity(0), Vec3{0.8, -0.6, 0});
    // XPBD's friction is implicit and seen before the weight: the creep is faster by about h (grip/m + g/creep).
    EXPECT_NEAR(speed, creep, (method.name == "xpbd" ? 0.1 : 1e-3) * creep) << method.name;
    EXPECT_NEAR(dot(simulation.velocity(0), scene.bodies[0].normal), 0, 1e-6) << method.name;
  }
}

TEST(Contact, FrictionBrakesASlideByCoulombsLawOnceItIsFast) {
  const Scene scene = onSlope(0.3);
  const double down = kGravity * 0.6, brake = 0.3 * kGravity * 0.8;
  const double slow = 0.3 * scene.particleMass * kGravity * 0.8 / scene.contact.grip;
  const auto rate = [&](double v) { return down - brake * v / std::sqrt(v * v + slow * slow); };
  double v = 0;
  constexpr int kSteps = 20000;
  for (int n = 0; n < kSteps; ++n) {
    constexpr double h = 1.0 / kSteps;
    const double k1 = rate(v), k2 = rate(v + h / 2 * k1), k3 = rate(v + h / 2 * k2), k4 = rate(v + h * k3);
    v += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  EXPECT_NEAR(v, down - brake, 0.05 * v);
  for (const Method& method : methods()) {
    Simulation simulation(scene, method);
    simulation.advanceTo(1);
    const double most = method.order > 2 ? 1e-6 : method.order == 2 && method.name != "imex" ? 2e-5 : 1e-2;
    EXPECT_NEAR(dot(simulation.velocity(0), Vec3{0.8, -0.6, 0}), v, most * v) << method.name;
  }
}

TEST(Contact, AParticleLeavesAFrictionlessBallAtTheAngleOfTheTextbook) {
  constexpr double kStart = 0.3;  // rad from the top
  Scene scene = particleOnFloor();
  scene.contact = {.stiffness = 3e6, .layer = 1e-6, .damping = 0.5, .friction = 0, .grip = 1, .gap = 0};
  const Vec3 middle{-std::sin(kStart), -std::cos(kStart), 0};
  scene.bodies = {{.shape = Shape::Ball, .at = middle, .radius = 1}};
  scene.dt = 5e-5;
  Simulation simulation(scene, findMethod("rk4"));
  double angle = kStart;
  for (int k = 0; k < 40000; ++k) {
    const Vec3 out = simulation.position(0) - middle;
    angle = std::acos(out.y / length(out));
    if (k > 2000 && simulation.ledger().stored["contact"] == 0) break;
    if (k % 1000 == 999) {
      const double push =
          scene.contact.stiffness * scene.contact.layer * pushShare((1 - length(out)) / scene.contact.layer);
      const double expected = scene.particleMass * kGravity * (3 * std::cos(angle) - 2 * std::cos(kStart));
      EXPECT_NEAR(push, expected, 0.02 * scene.particleMass * kGravity) << angle;
    }
    simulation.tick();
  }
  // A softer layer holds on for longer.
  EXPECT_NEAR(std::cos(angle), 2.0 / 3 * std::cos(kStart), 8e-3);
}

/// A rope that is drawn over a capsule without weight, both ends at one speed, the one towards it, the other away.
Scene ropeOverCapsule(double friction) {
  Scene scene = emptyWorld(81, 1);
  scene.spacing = 0.025, scene.particleMass = 1e-3;
  scene.structural = {1000, 0.1};
  scene.drag = 1e-4;
  scene.pins = {{"top-left"}, {"top-right"}};
  scene.contact = {.stiffness = 2000, .layer = 0.001, .damping = 0.5, .friction = friction, .grip = 10};
  scene.bodies = {{.shape = Shape::Capsule, .at = {0, -0.3, -1}, .axis = {0, 0, 2}, .radius = 0.3}};
  const std::vector<Place> left = {{"top-left"}}, right = {{"top-right"}};
  constexpr double kSpeed = 0.3;
  scene.moves = {{left, {0, -0.7, 0}, 0, 1},
                 {right, {0, -0.7, 0}, 0, 1},
                 {left, {0.75 * kSpeed, 0.66 * kSpeed, 0}, 1.2, 1.5},
                 {right, {0.75 * kSpeed, -0.66 * kSpeed, 0}, 1.2, 1.5}};
  scene.dt = 1e-4;
  return scene;
}

TEST(Contact, TheTensionOfARopeOverACapsuleGrowsLikeThatOfARopeOverABollard) {
  for (const double friction : {0.2, 0.5}) {
    const Scene scene = ropeOverCapsule(friction);
    Simulation simulation(scene, findMethod("rk4"));
    double ratio = 0, expected = 0;
    constexpr int kSamples = 60;  // over the time in which the rope moves by one spacing and more
    for (int k = 0; k < kSamples; ++k) {
      simulation.advanceTo(2 + 0.005 * k);
      const Vec3 before = simulation.position(1) - simulation.position(0);
      const Vec3 after = simulation.position(80) - simulation.position(79);
      ratio += (length(after) - scene.spacing) / (length(before) - scene.spacing) / kSamples;
      const double turn = std::acos(dot(before, after) / length(before) / length(after));
      const double each = (length(before) + length(after)) / 2 / 0.3, half = friction * std::tan(each / 2);
      const double now = std::pow((1 + half) / (1 - half), turn / each);
      expected += now / kSamples;
      EXPECT_NEAR(now, std::exp(friction * turn), 0.01 * now);
    }
    EXPECT_NEAR(ratio, expected, 0.02 * expected) << friction;
    EXPECT_EQ(simulation.status(), Status::Ok);
  }
}

TEST(Contact, ABallCarriesTheWholeWeightOfAClothAtRestOnIt) {
  Scene scene = emptyWorld(9, 9);
  scene.start = Start::Flat;
  scene.spacing = 0.05, scene.particleMass = 1e-3;
  scene.structural = {100, 0.02}, scene.shear = {70, 0.02}, scene.bend = {10, 0.02};
  scene.gravity = {0, -kGravity, 0}, scene.drag = 0.003;
  scene.contact = {.friction = 0.8};
  fillContact(scene);
  scene.bodies = {{.shape = Shape::Ball, .at = {0, -0.32, 0.2}, .radius = 0.3}};
  scene.dt = 5e-4;
  Simulation simulation(scene, findMethod("rk4"));
  simulation.advanceTo(4);
  const ContactReference reference(scene);
  Vec3 carried{};
  for (int i = 0; i < 81; ++i) {
    carried = carried + reference.forceOn(4, simulation.position(i), simulation.velocity(i));
  }
  const double weight = 81 * scene.particleMass * kGravity;
  EXPECT_NEAR(carried.y, weight, 1e-3 * weight);
  EXPECT_NEAR(carried.x, 0, 1e-3 * weight);
  EXPECT_NEAR(carried.z, 0, 1e-3 * weight);
}

TEST(Contact, PinsFeelNothing) {
  Scene scene = emptyWorld(2, 1);
  scene.spacing = 0.1;
  scene.pins = {{"top-left"}, {"top-right"}};
  scene.contact = {.stiffness = 100, .layer = 0.01, .damping = 0.3, .friction = 0.5, .grip = 1};
  scene.bodies = {{.shape = Shape::Ball, .radius = 0.5, .name = "ball"}, {.shape = Shape::Plane, .at = {0, 1, 0}}};
  scene.moves = {{.what = {{"top-left"}}, .velocity = {1, 0, 0}, .at = 0.1, .duration = 1},
                 {.velocity = {0, 1, 0}, .at = 0.2, .duration = 1, .body = "ball"}};
  scene.dt = 0.01;
  for (const Method& method : methods()) {
    Simulation simulation(scene, method, {.ledger = true});
    simulation.advanceTo(2);
    EXPECT_EQ(simulation.position(1), (Vec3{0.05, 0, 0})) << method.name;
    EXPECT_LE(length(simulation.position(0) - Vec3{0.95, 0, 0}), 1e-15) << method.name;
    const Ledger ledger = simulation.ledger();
    EXPECT_EQ(ledger.stored["contact"], 0) << method.name;
    EXPECT_EQ(ledger.dissipated, 0) << method.name;
    EXPECT_EQ(ledger.work["bodies"], 0) << method.name;
    EXPECT_NEAR(ledger.work["pins"], 0, 1e-12) << method.name;
  }
}

/// A sheet that falls over a ball, a box or a capsule, and on to a floor, with friction.
Scene sheetOver(Shape shape) {
  Scene scene = emptyWorld(8, 7);
  scene.start = Start::Flat;
  scene.spacing = 0.1, scene.particleMass = 5e-3;
  scene.structural = {60, 0.02}, scene.shear = {40, 0.02}, scene.bend = {5, 0.01};
  scene.gravity = {0.3, -kGravity, 0.1}, scene.drag = 0.002;
  scene.contact = {.stiffness = 50, .layer = 0.05, .damping = 0.2, .friction = 0.4, .grip = 0.2};
  const Vec3 low{0.06, -0.35, 0.27};
  const Body floor{.shape = Shape::Plane, .at = {0, -0.55, 0}, .normal = {0, 1, 0}};
  scene.bodies = {floor};
  if (shape == Shape::Ball) scene.bodies.push_back({.shape = shape, .at = low, .radius = 0.25});
  if (shape == Shape::Capsule) {
    scene.bodies.push_back({.shape = shape, .at = {-0.2, -0.3, 0.1}, .axis = {0.3, 0, 0.4}, .radius = 0.2});
  }
  if (shape == Shape::Box) {
    scene.bodies.push_back({.shape = shape, .at = low, .half = {0.25, 0.2, 0.22}, .radius = 0.12});
  }
  return scene;
}

TEST(Contact, ASheetOverEachShapeMovesAsTheModelSays) {
  for (const Shape shape : {Shape::Plane, Shape::Ball, Shape::Capsule, Shape::Box}) {
    Scene scene = sheetOver(shape);
    constexpr double kSeconds = 0.4;
    scene.dt = 1e-4;
    Simulation simulation(scene, findMethod("rk4"));
    double touched = 0;
    for (int k = 1; k <= 40; ++k) {
      simulation.advanceTo(kSeconds * k / 40);
      touched = std::max(touched, simulation.ledger().stored["contact"]);
    }
    Points expected = Bench<double>(scene).points();
    ContactReference(scene).advance(expected, kSeconds, 6000);
    Points found = expected;
    for (int i = 0; i < simulation.sheet().count(); ++i) found.x[std::size_t(i)] = simulation.position(i);
    EXPECT_LT(distance(found, expected), 1e-7 * simulation.sheet().size()) << int(shape);
    EXPECT_GT(touched, 1e-5) << int(shape);
  }
}

}  // namespace
}  // namespace tyg::test

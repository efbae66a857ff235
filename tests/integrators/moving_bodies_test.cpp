// Bodies that move: where they are, the work that they do, the same bits however a run is cut, and that no adaptive
// method leaps over them.
#include <gtest/gtest.h>

#include <cmath>

#include "contact_reference.h"
#include "core/forces/row_kernel.h"
#include "core/forces/terms/contact.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg::test {
namespace {

/// A sheet between a floor, a ball that moves twice and a box, some of its pins moving too.
Scene busySheet() {
  Scene scene = emptyWorld(21, 9);
  scene.start = Start::Flat;
  scene.spacing = 0.1, scene.particleMass = 5e-3;
  scene.structural = {60, 0.02}, scene.shear = {40, 0.02}, scene.bend = {5, 0.01};
  scene.gravity = {0, -9.81, 0}, scene.drag = 0.002;
  scene.pins = {{"top-left"}};
  scene.contact = {.stiffness = 100, .layer = 0.02, .damping = 0.3, .friction = 0.4, .grip = 0.3};
  scene.bodies = {{.shape = Shape::Plane, .at = {0, -0.5, 0}},
                  {.shape = Shape::Ball, .at = {-0.5, -0.4, 0.4}, .radius = 0.25, .name = "ball"},
                  {.shape = Shape::Box, .at = {0.5, -0.3, 0.4}, .half = {0.2, 0.2, 0.3}, .radius = 0.1, .name = "box"},
                  {.shape = Shape::Capsule, .at = {1, -0.4, 0}, .axis = {0, 0, 1}, .radius = 0.15},
                  {.shape = Shape::Plane, .at = {-1, -0.45, 0}, .normal = {0.6, 0.8, 0}}};
  scene.moves = {{.velocity = {1, 1.5, 0}, .at = 0.0513, .duration = 0.2, .body = "ball"},
                 {.velocity = {0, 0.5, 0.5}, .at = 0.15, .duration = 1.0 / 3, .body = "ball"},
                 {.velocity = {0, 1, 0}, .at = 0.1, .duration = 0.2, .body = "box"},
                 {.what = {{"top-left"}}, .velocity = {0, -1, 0}, .at = 0.07, .duration = 0.2}};
  scene.dt = 1e-3, scene.tolerance = 2e-5;
  return scene;
}

TEST(MovingBodies, AreWhereTheirVelocitiesBringThem) {
  constexpr double kRounding = 1e-15;  // m
  const Scene scene = busySheet();
  const auto expect = [&](double time, const Vec3& moved) {
    EXPECT_LE(length(placeOf(scene, 1, time) - scene.bodies[1].at - moved), kRounding) << time;
  };
  expect(0, {});
  expect(0.0513, {});
  expect(0.1013, {0.05, 0.075, 0});
  expect(0.2, {0.1487, 0.22305 + 0.025, 0.025});
  expect(0.3, {0.2, 0.375, 0.075});
  expect(0.15 + 1.0 / 3, {0.2, 0.3 + 0.5 / 3, 0.5 / 3});
  expect(7, {0.2, 0.3 + 0.5 / 3, 0.5 / 3});
  EXPECT_EQ(placeOf(scene, 3, 7), scene.bodies[3].at);
}

TEST(MovingBodies, AParticleOnALiftRidesToItsEnd) {
  Scene scene = particleOnFloor();
  scene.bodies[0].name = "lift";
  scene.moves = {{.velocity = {0.2, 0.5, 0}, .at = 0.31, .duration = 1.0 / 3, .body = "lift"}};
  scene.contact.damping = 0.5, scene.contact.friction = 0.5;
  scene.dt = 2e-4;
  const double weight = scene.particleMass * 9.81;
  for (const Method& method : methods()) {
    Simulation simulation(scene, method);
    simulation.advanceTo(4);
    const double most = method.name == "xpbd" ? 1e-5 : 1e-7;
    EXPECT_NEAR(simulation.position(0).y, 0.5 / 3 - depthOfPush(scene.contact, weight), most) << method.name;
    EXPECT_NEAR(simulation.position(0).x, 0.0667, 0.02) << method.name;  // it slips, and the more where it hops
    EXPECT_EQ(simulation.status(), Status::Ok) << method.name;
  }
}

TEST(MovingBodies, DoWorkThatTheLedgerKnows) {
  for (const auto& [name, most] : {std::pair{"rk4", 1e-6},
                                   {"dopri54", 1e-6},
                                   {"bs32", 3e-5},
                                   {"rkc2", 1e-3},
                                   {"leapfrog", 3e-3},
                                   {"imex", 3e-2},
                                   {"symplectic-euler", 3e-2},
                                   {"backward-euler", 0.1},
                                   {"xpbd", 0.1}}) {
    Scene scene = busySheet();
    scene.dt = 5e-4, scene.tolerance = 0;
    Simulation simulation(scene, findMethod(name), {.ledger = true});
    simulation.advanceTo(0.6);
    const Ledger ledger = simulation.ledger();
    EXPECT_LT(std::abs(ledger.drift), most) << name;
    EXPECT_GT(ledger.work["bodies"], 0.05) << name;
    EXPECT_GT(ledger.dissipated, 0.05) << name;
    EXPECT_EQ(ledger.work["wind"], 0) << name;
  }
}

TEST(MovingBodies, TheAlarmKnowsTheirWorkWithoutTheLedger) {
  Scene blow = particleOnFloor();  // an elevator that starts at 5 m/s, between two energy checks of an adaptive method
  blow.bodies[0].name = "lift";
  blow.moves = {{.velocity = {0.2, 5, 0}, .at = 0.31, .duration = 1.0 / 15, .body = "lift"}};
  for (const Method& method : methods()) {
    Simulation lifted(blow, method), followed(blow, method, {.ledger = true});
    lifted.advanceTo(2), followed.advanceTo(2);
    if (method.name != "explicit-euler") {
      EXPECT_EQ(lifted.status(), Status::Ok) << method.name;
    }
    EXPECT_EQ(lifted.status(), followed.status()) << method.name;
    EXPECT_EQ(lifted.ledger().work["bodies"], followed.ledger().work["bodies"]) << method.name;
  }
  const Scene scene = busySheet();
  Simulation exact(scene, findMethod("leapfrog"), {.ledger = true}), estimated(scene, findMethod("leapfrog"));
  exact.advanceTo(1), estimated.advanceTo(1);
  EXPECT_EQ(estimated.hash(), exact.hash());
  EXPECT_EQ(estimated.ledger().work["bodies"], exact.ledger().work["bodies"]);
  EXPECT_EQ(estimated.status(), Status::Ok);
}

TEST(MovingBodies, TheirWorkIsCountedOnceWhereverTheLedgerIsFollowed) {
  const Scene scene = busySheet();
  for (const Method& method : methods()) {
    if (method.name == "explicit-euler") continue;  // unstable
    Simulation exact(scene, method, {.ledger = true}), switched(scene, method);
    exact.tick(400);
    switched.tick(120);
    const Snapshot early = switched.save();
    switched.followLedger(true);
    switched.tick(60);
    switched.followLedger(false);
    switched.tick(220);
    const double work = exact.ledger().work["bodies"], most = 1e-6 * work;
    EXPECT_NEAR(switched.ledger().work["bodies"], work, most) << method.name;
    switched.followLedger(true);
    switched.restore(early);
    switched.tick(280);
    EXPECT_NEAR(switched.ledger().work["bodies"], work, most) << method.name;
    EXPECT_EQ(switched.hash(), exact.hash()) << method.name;
  }
}

TEST(MovingBodies, GiveTheSameBitsInOneCallAndTickByTickForEveryMethodAndThread) {
  Scene scene = busySheet();
  for (const Precision precision : {Precision::Float, Precision::Double}) {
    scene.precision = precision;
    for (const Method& method : methods()) {
      const int ticks = method.name == "backward-euler" ? 100 : 250;
      Simulation together(scene, method, {.threads = 3, .keepGoing = true});
      Simulation single(scene, method, {.threads = 1, .keepGoing = true});
      together.tick(ticks);
      for (int k = 0; k < ticks; ++k) single.tick();
      EXPECT_EQ(together.hash(), single.hash()) << method.name;
      Simulation seen(scene, method, {.threads = 2, .ledger = true, .keepGoing = true});
      seen.tick(ticks);
      EXPECT_EQ(seen.hash(), single.hash()) << method.name;
    }
  }
}

TEST(MovingBodies, GiveTheSameBitsAtEveryVectorLevel) {
  Scene scene = busySheet();
  for (const Precision precision : {Precision::Float, Precision::Double}) {
    scene.precision = precision;
    for (const char* name : {"leapfrog", "rk4", "symplectic-euler", "imex"}) {
      std::vector<std::uint64_t> hashes;
      std::vector<double> energies;
      for (int level = 0; level <= int(bestVectorLevel()); ++level) {
        useVectorLevel(VectorLevel(level));
        Simulation simulation(scene, findMethod(name), {.threads = 1, .ledger = true});
        simulation.advanceTo(0.4);
        hashes.push_back(simulation.hash());
        const Ledger ledger = simulation.ledger();
        energies.push_back(ledger.stored["contact"] + ledger.dissipated + ledger.work["bodies"]);
        EXPECT_EQ(hashes.back(), hashes.front()) << name << " level " << level;
        EXPECT_EQ(energies.back(), energies.front()) << name << " level " << level;
      }
      useVectorLevel({});
    }
  }
}

TEST(MovingBodies, GiveTheSameBitsAfterGoingBackAndFromTheLog) {
  const Scene scene = busySheet();
  for (const Method& method : methods()) {
    Simulation simulation(scene, method, {.threads = 1});
    simulation.tick(60);
    simulation.push(50, {0, 0.3, 0.1}, 20);
    Scene heavier = scene;
    heavier.contact.friction = 0.1, heavier.bodies[2].at.y = -0.35;
    simulation.useLiveParameters(heavier);
    simulation.tick(40);
    const Snapshot snapshot = simulation.save();
    simulation.tick(60);
    const std::uint64_t hash = simulation.hash();
    const double work = simulation.ledger().work["bodies"];
    simulation.restore(snapshot);
    simulation.tick(60);
    EXPECT_EQ(simulation.hash(), hash) << method.name;
    EXPECT_EQ(simulation.ledger().work["bodies"], work) << method.name;
    Simulation again(scene, method, {.threads = 2});
    again.replay(simulation.log(), methods());
    again.tick(160);
    EXPECT_EQ(again.hash(), hash) << method.name;
  }
}

/// One particle above, or beside, a small body that is 20 m away.
Scene farAway(const Body& body) {
  Scene scene = particleOnFloor();
  scene.bodies = {body};
  scene.duration = 100, scene.dt = 1, scene.tolerance = 5e-6;
  return scene;
}

TEST(MovingBodies, AdaptiveMethodsDoNotLeapOverThem) {
  const Body ball{.shape = Shape::Ball, .at = {0, -20, 0}, .radius = 0.05, .name = "body"};
  const Body rod{.shape = Shape::Capsule, .at = {0, -20, -1}, .axis = {0, 0, 2}, .radius = 0.05, .name = "body"};
  for (const Body& body : {ball, rod}) {
    Scene falls = farAway(body);
    Scene isMet = falls, isPushed = falls;
    isMet.gravity = isPushed.gravity = {};
    isMet.moves = {{.velocity = {0, 50, 0}, .at = 0.1, .duration = 1, .body = "body"}};
    isPushed.pushes = {{{"top-left"}, {0, -5, 0}, 0, 1}};
    Scene isShot = isPushed;
    isShot.pushes = {{{"top-left"}, {0, -50, 0}, 0, 0.01}};
    for (const Scene& scene : {falls, isMet, isPushed, isShot}) {
      for (const Method& method : methods()) {
        if (!method.adaptive) continue;
        Simulation simulation(scene, method, {.ledger = true});
        simulation.advanceTo(2.5);
        EXPECT_GT(simulation.ledger().dissipated, 1e-3) << method.name << " passed through without a touch";
      }
    }
  }
}

}  // namespace
}  // namespace tyg::test

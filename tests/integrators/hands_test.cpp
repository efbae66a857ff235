// Cuts, pins and grabs: what is left moves as it would without them, the ledger balances, and all of it replays.
#include <gtest/gtest.h>

#include <cmath>

#include "core/forces/row_kernel.h"
#include "test_systems.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg::test {
namespace {

Scene hangingSheet() {
  Scene scene = softSheet(Damping::Relative);
  scene.columns = 9, scene.rows = 7, scene.spacing = 0.2, scene.particleMass = 0.05;
  scene.pins = {{"top"}};
  scene.dt = 1.0 / 512;
  scene.tolerance = 1e-5;
  return scene;
}

/// The report's own method takes longer steps than it says.
double roundingOf(const Method& method) { return method.name == "report-rk4" ? 1e-3 : 1e-9; }

constexpr CutLine kAcross{-1, 3.5, 9, 3.5};

TEST(CutCloth, FallsFreelyBelowTheCut) {
  Scene scene = hangingSheet();
  scene.drag = 0;
  for (const Method& method : methods()) {
    Simulation simulation(scene, method);
    simulation.tick(100);
    simulation.cut(kAcross);
    const auto meanFall = [&] {
      double sum = 0;
      for (int particle = 4 * 9; particle < 7 * 9; ++particle) sum += simulation.velocity(particle).y / 27;
      return sum;
    };
    const double before = meanFall(), at = simulation.time();
    simulation.tick(100);
    EXPECT_NEAR(meanFall() - before, scene.gravity.y * (simulation.time() - at), roundingOf(method)) << method.name;
  }
}

TEST(CutCloth, LosesTheEnergyOfTheSpringsThatAreGone) {
  for (const char* name : {"rk4", "leapfrog", "imex", "xpbd", "dopri54"}) {
    Simulation simulation(hangingSheet(), findMethod(name), {.ledger = true});
    simulation.tick(150);
    const Ledger before = simulation.ledger();
    simulation.cut({4.5, -1, 4.5, 8});
    const Ledger after = simulation.ledger();
    const double lost = before.stored["elastic"] - after.stored["elastic"];
    EXPECT_GT(lost, 0);
    EXPECT_NEAR(after.dissipated - before.dissipated, lost, 1e-12 * after.scale) << name;
    EXPECT_NEAR(after.drift, before.drift, 1e-12) << name;
  }
}

TEST(CutCloth, MovesAsTwoSheetsDo) {
  Scene whole = hangingSheet();
  Scene half = whole;
  half.columns = 4;
  Simulation cut(whole, findMethod("rk4")), alone(half, findMethod("rk4"));
  cut.cut({3.5, -1, 3.5, 8});
  cut.tick(400), alone.tick(400);
  for (int row = 0; row < 7; ++row) {
    for (int column = 0; column < 4; ++column) {
      const Vec3 a = cut.position(row * 9 + column), b = alone.position(row * 4 + column);
      const double aside = half.spacing * 2.5;  // the middle of a narrower sheet is elsewhere
      EXPECT_LT(std::hypot(a.x - (b.x - aside), a.y - b.y, a.z - b.z), 1e-12);
    }
  }
}

TEST(CutCloth, HasTheSameBitsAtEveryVectorLevelThreadCountFusedOrNotAndFromASnapshot) {
  Scene scene = loadScene("curtain");
  scene.pushes.clear();
  scene.air = {1.2, 1.2}, scene.winds = {{.velocity = {1, 0, 2}}};
  scene.integrator = "leapfrog";
  for (const Precision precision : {Precision::Float, Precision::Double}) {
    scene.precision = precision;
    const auto hash = [&](int threads, bool ledger, bool stops) {
      Simulation simulation(scene, findMethod("leapfrog"), {.threads = threads, .ledger = ledger});
      simulation.tick(40);
      simulation.cut({0.5, 3.3, 9.2, 12.1});
      if (stops) {
        const Snapshot saved = simulation.save();
        simulation.cut(kAcross), simulation.tick(10);
        simulation.restore(saved);
      }
      simulation.tick(100);
      return simulation.hash();
    };
    const std::uint64_t expected = hash(1, false, false);
    EXPECT_EQ(hash(2, false, false), expected);
    EXPECT_EQ(hash(1, true, false), expected);
    EXPECT_EQ(hash(2, false, true), expected);
    for (const VectorLevel level : {VectorLevel::Baseline, VectorLevel::V3, VectorLevel::V4}) {
      if (level > bestVectorLevel()) continue;
      useVectorLevel(level);
      EXPECT_EQ(hash(1, false, false), expected);
      useVectorLevel({});
    }
  }
}

TEST(CutCloth, OfASceneIsThatOfAHandAtTheSameTick) {
  Scene scene = hangingSheet();
  scene.cuts = {{{4.5, -1, 4.5, 8}, 64 * scene.dt}};
  for (const Method& method : methods()) {
    if (method.adaptive) continue;
    Simulation timed(scene, method);
    Scene without = scene;
    without.cuts.clear();
    Simulation byHand(without, method);
    byHand.tick(64), byHand.cut(scene.cuts[0].line);
    byHand.tick(64), timed.tick(128);
    EXPECT_EQ(timed.hash(), byHand.hash()) << method.name;
  }
}

TEST(CutCloth, IsMendedWithWork) {
  Simulation simulation(hangingSheet(), findMethod("rk4"), {.ledger = true});
  simulation.tick(50);
  simulation.cut(kAcross), simulation.cut({4.5, -1, 4.5, 8});
  simulation.tick(20);
  simulation.mend(2);
  EXPECT_TRUE(simulation.sheet().missing.none());
  const Ledger ledger = simulation.ledger();
  EXPECT_GT(ledger.work["pushes"], 0) << "the gap has opened meanwhile";
  simulation.tick(100);
  EXPECT_LT(std::abs(simulation.ledger().drift), 1e-4);
  EXPECT_EQ(simulation.status(), Status::Ok);
}

/// A sheet of one size on a grid of n x n, held above and below, with a notch to its middle from the left. It is drawn
/// apart slowly, while it is damped so much that it stays at rest.
Scene notchedSheet(int n) {
  Scene scene = emptyWorld(20, 20);
  scene.spacing = 0.05, scene.particleMass = 0.01;
  scene.structural = {400, 0.02}, scene.shear = {100, 0.01};
  scene.drag = 0.02;
  for (int column = 0; column < 20; ++column) {
    scene.pins.push_back({"", column, 0});
    scene.pins.push_back({"", column, 19});
  }
  scene.cuts = {{{-1, 9.5, 9.5, 9.5}, 0}};
  scene.integrator = "leapfrog", scene.dt = 2e-4;
  scene = withSheet(scene, n, n);
  scene.pins = {{"top"}};
  for (int column = 0; column < n; ++column) scene.pins.push_back({"", column, n - 1});
  scene.moves = {{{{"top"}}, {0, 0.05, 0}, 0, 100}};
  scene.tear.toughness = 2;
  return scene;
}

/// How far the sheet has been drawn when its first spring breaks, m.
double drawnAtFirstTear(int n) {
  Simulation simulation(notchedSheet(n), findMethod("leapfrog"));
  simulation.tick(1);
  const Missing notch = simulation.sheet().missing;
  EXPECT_FALSE(notch.none());
  while (simulation.sheet().missing == notch && simulation.time() < 10 && simulation.status() == Status::Ok) {
    simulation.tick();
  }
  EXPECT_EQ(simulation.status(), Status::Ok);
  return 0.05 * simulation.time();
}

TEST(TornCloth, OnAFinerGridTearsAtTheSameLoad) {
  const double coarse = drawnAtFirstTear(20), fine = drawnAtFirstTear(40);
  EXPECT_NEAR(fine / coarse, 1, 0.15);
  EXPECT_LT(coarse, 0.4);
}

TEST(TornCloth, OpensFromTheNotchAndBalances) {
  Simulation simulation(notchedSheet(20), findMethod("leapfrog"), {.ledger = true});
  simulation.advanceTo(7);
  EXPECT_EQ(simulation.status(), Status::Ok);
  int torn = 0;
  for (int column = 10; column < 20; ++column)
    torn += int(simulation.sheet().missing.has(9 * 20 + column, Missing::Down));
  EXPECT_EQ(torn, 10) << "straight on to the other side";
  EXPECT_LT(std::abs(simulation.ledger().drift), 0.01);
}

TEST(TornCloth, IsTheSameByTicksAndByTimesAndFromASnapshot) {
  Scene scene = notchedSheet(20);
  scene.moves[0].velocity.y = 1;
  Simulation byTicks(scene, findMethod("leapfrog")), byTimes(scene, findMethod("leapfrog"));
  byTicks.tick(300);
  const Snapshot saved = byTicks.save();
  byTicks.tick(500), byTimes.advanceTo(800 * scene.dt);
  EXPECT_FALSE(byTicks.sheet().missing == Simulation(scene, findMethod("leapfrog")).sheet().missing);
  EXPECT_EQ(byTicks.sheet().missing, byTimes.sheet().missing);
  const std::uint64_t hash = byTicks.hash();
  byTicks.restore(saved);
  byTicks.tick(500);
  EXPECT_EQ(byTicks.hash(), hash);
}

TEST(TornCloth, StaysWholeBelowTheStrainOfItsToughness) {
  for (const double factor : {0.99, 1.01}) {
    Scene scene = emptyWorld(1, 2);
    scene.structural = {100, 1};
    scene.pins = {{"top-left"}, {"bottom-left"}};
    scene.displacements = {{{"bottom-left"}, {0, -factor * 0.2, 0}}};  // sqrt(2 G / (ks s)) = 0.2
    scene.tear.toughness = 0.2 * 0.2 * 100 / 2;
    scene.dt = 0.01;
    Simulation simulation(scene, findMethod("rk4"));
    simulation.tick(2);
    EXPECT_EQ(simulation.sheet().missing.none(), factor < 1);
  }
}

TEST(GrabbedParticle, GoesWhereTheHandGoesInEveryMethod) {
  for (const Method& method : methods()) {
    Simulation simulation(hangingSheet(), method, {.ledger = true});
    simulation.tick(30);
    constexpr int kHeld = 50;
    const Vec3 from = simulation.position(kHeld);
    simulation.grab(kHeld, {0.5, 0.25, -1});
    simulation.tick(64);
    simulation.grab(kHeld, {0, 0, 2});
    simulation.tick(32);
    const Vec3 to = simulation.position(kHeld);
    const double h = simulation.dt();
    EXPECT_NEAR(to.x, from.x + 64 * h * 0.5, roundingOf(method)) << method.name;
    EXPECT_NEAR(to.y, from.y + 64 * h * 0.25, roundingOf(method)) << method.name;
    EXPECT_NEAR(to.z, from.z - 64 * h + 32 * h * 2, roundingOf(method)) << method.name;
    simulation.release(kHeld);
    EXPECT_EQ(simulation.velocity(kHeld), (Vec3{0, 0, 2})) << method.name;
    simulation.tick(20);
    EXPECT_NE(simulation.velocity(kHeld), (Vec3{0, 0, 2})) << method.name;
    EXPECT_EQ(simulation.status(), Status::Ok) << method.name;
    EXPECT_NE(simulation.ledger().work["pins"], 0) << method.name;
    if (method.order == 4) {
      EXPECT_LT(std::abs(simulation.ledger().drift), 1e-4) << method.name;
    }
  }
}

TEST(GrabbedParticle, ThatIsAPinStaysOneWhereItWasTaken) {
  Simulation simulation(hangingSheet(), findMethod("leapfrog"));
  simulation.grab(0, {0, 1, 0}), simulation.tick(10), simulation.release(0);
  const Vec3 there = simulation.position(0);
  EXPECT_EQ(simulation.velocity(0), Vec3{});
  simulation.tick(50);
  EXPECT_EQ(simulation.position(0), there);
  EXPECT_GT(there.y, 0);
}

TEST(PinnedParticle, StopsAndHoldsUntilItIsFreed) {
  for (const Method& method : methods()) {
    Simulation simulation(hangingSheet(), method, {.ledger = true});
    simulation.tick(40);
    simulation.pin(60, true), simulation.pin(3, false);
    const Vec3 there = simulation.position(60);
    const double drift = simulation.ledger().drift;
    EXPECT_NEAR(simulation.ledger().drift, drift, 1e-12) << method.name;
    const Vec3 top = simulation.position(3);
    simulation.tick(40);
    EXPECT_EQ(simulation.position(60), there) << method.name;
    EXPECT_NE(simulation.position(3), top) << method.name;
    simulation.pin(60, false);
    simulation.tick(40);
    EXPECT_NE(simulation.position(60), there) << method.name;
    if (method.order == 4) {
      EXPECT_LT(std::abs(simulation.ledger().drift), 1e-4) << method.name;
    }
  }
}

TEST(Hands, ReplayToTheSameBitsAndGoBack) {
  for (const Method& method : methods()) {
    Simulation live(hangingSheet(), method);
    live.tick(5), live.grab(30, {0.2, 0, 0.3}), live.tick(3), live.push(40, {0, 0, 0.5}, 20), live.tick(2);
    const Snapshot saved = live.save();
    live.cut({2.5, -1, 2.5, 3}), live.pin(40, true), live.tick(4), live.release(30), live.pin(40, false), live.tick(9);
    live.mend(), live.tick(6);
    const EventLog log = parseEventLog(formatEventLog(live.log()), "log");
    Simulation again(hangingSheet(), method);
    again.replay(log, methods());
    again.tick(29);
    EXPECT_EQ(again.hash(), live.hash()) << method.name;
    Simulation straight(hangingSheet(), method);
    straight.tick(5), straight.grab(30, {0.2, 0, 0.3}), straight.tick(3), straight.push(40, {0, 0, 0.5}, 20);
    straight.tick(9);
    live.restore(saved);
    EXPECT_TRUE(live.sheet().missing.none());
    live.tick(7);
    EXPECT_EQ(live.hash(), straight.hash()) << method.name;
  }
}

TEST(Hands, ReplayWhatTheyDidAfterTheLastTick) {
  Simulation live(hangingSheet(), findMethod("rk4")), again(hangingSheet(), findMethod("rk4"));
  live.tick(40), live.pin(60, true), live.cut(kAcross);
  again.replay(live.log(), methods());
  again.tick(40);
  EXPECT_EQ(again.hash(), live.hash());
  EXPECT_EQ(again.sheet(), live.sheet());
}

TEST(Hands, RefuseWhatIsNotThere) {
  Simulation simulation(hangingSheet(), findMethod("rk4"));
  EXPECT_THROW(simulation.pin(63, true), InputError);
  EXPECT_THROW(simulation.grab(-1, {}), InputError);
  EXPECT_THROW(simulation.grab(0, {NAN, 0, 0}), InputError);
  EXPECT_THROW(simulation.release(999), InputError);
  EXPECT_THROW(simulation.cut({1, 2, 1, 2}), InputError);
  EXPECT_TRUE(simulation.log().events.empty());
}

}  // namespace
}  // namespace tyg::test

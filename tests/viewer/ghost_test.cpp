// The ghost beside a live simulation: same time, same pushes, back in time with it, and what it says about distances.
#include "viewer/ghost.h"

#include <gtest/gtest.h>

#include <cmath>

#include "study/motion/error.h"
#include "study/motion/reference.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

constexpr double kPlenty = 1e9;  // s a frame
double stillClock() { return 0; }

Scene poke() { return loadScene("poke", methodNames()); }
Simulation liveOf(const Scene& scene, std::string_view method = "leapfrog") {
  return {scene, findMethod(method), {.threads = 1}};
}
void followFully(Ghost& ghost, const Simulation& live) { ghost.follow(live, kPlenty, stillClock); }

/// Ticks with a push by hand and a change of step on the way.
void runEventfully(Simulation& live, Ghost& ghost) {
  live.tick(20), followFully(ghost, live);
  live.push(210, {0, 0, 3}, 30);
  live.tick(25), followFully(ghost, live);
  live.useStep(0.001);
  live.tick(40), followFully(ghost, live);
}

TEST(Ghost, OfTheSameMethodIsWhereTheLiveClothIs) {
  Simulation live = liveOf(poke());
  Ghost ghost(live, &findMethod("leapfrog"));
  runEventfully(live, ghost);
  ASSERT_TRUE(ghost.gap());
  EXPECT_EQ(ghost.gap()->time, live.time());
  EXPECT_EQ(ghost.gap()->largest, 0);
  EXPECT_EQ(ghost.behind(), 0);
}

TEST(Ghost, OfTheReferenceTellsTheErrorThatAFinerReferenceTells) {
  const Scene scene = poke();
  Simulation live = liveOf(scene);
  Ghost ghost(live, nullptr);
  Scene fine = scene;
  fine.tolerance = 1e-12 * live.sheet().size();
  Simulation truth(fine, findMethod("dopri54"), {.threads = 1});
  live.tick(400), truth.tick(400), followFully(ghost, live);
  std::vector<Vec3> a, b, c;
  for (int particle = 0; particle < live.sheet().count(); ++particle) {
    a.push_back(live.position(particle));
    b.push_back(truth.position(particle));
  }
  const Distance error = distanceBetween(a, b);
  constexpr double kTenTimesBetter = 0.1;  // what a reference has to be
  ASSERT_TRUE(ghost.gap());
  EXPECT_TRUE(ghost.gap()->means());
  EXPECT_NEAR(ghost.gap()->rms, error.rms, kTenTimesBetter * error.rms);
  EXPECT_NEAR(ghost.gap()->largest, error.largest, kTenTimesBetter * error.largest);
  EXPECT_TRUE(std::isnan(ghost.horizon()));
}

TEST(Ghost, IsPushedWhereverTheLiveClothIs) {
  Simulation live = liveOf(poke(), "rk4");
  Ghost ghost(live, nullptr);
  runEventfully(live, ghost);
  Simulation unpushed = liveOf(poke(), "rk4");
  unpushed.advanceTo(live.time());
  const double moved = std::abs(live.position(210).z - unpushed.position(210).z);
  EXPECT_GT(moved, 100 * ghost.gap()->largest);
}

TEST(Ghost, ChangesItsWorldWithTheLiveCloth) {
  Simulation live = liveOf(poke());
  Ghost same(live, &findMethod("leapfrog")), reference(live, nullptr);
  live.tick(20), followFully(same, live), followFully(reference, live);
  Scene moon = poke();
  moon.gravity = {0, -1.62, 0}, moon.bend.ks = 50, moon.tolerance = 0.1;
  live.useLiveParameters(moon);
  live.tick(60), followFully(same, live), followFully(reference, live);
  EXPECT_EQ(same.gap()->largest, 0);
  constexpr double kOfTheMethod = 1e-3;  // of the size, what leapfrog is off at this step
  EXPECT_LT(reference.gap()->largest, kOfTheMethod * live.sheet().size());
}

TEST(Ghost, DoesNotChangeMethodWithTheLiveCloth) {
  Simulation live = liveOf(poke());
  Ghost ghost(live, &findMethod("leapfrog"));
  live.tick(10);
  live.useMethod(findMethod("symplectic-euler"));
  live.tick(50), followFully(ghost, live);
  Simulation plain = liveOf(poke());
  plain.tick(60);
  EXPECT_FLOAT_EQ(ghost.positions()[3 * 399], static_cast<float>(plain.position(399).x));
  EXPECT_GT(ghost.gap()->largest, 0);
}

TEST(Ghost, GoesBackInTimeWithTheLiveCloth) {
  Simulation live = liveOf(poke());
  Ghost ghost(live, &findMethod("leapfrog"));
  live.tick(300), followFully(ghost, live);
  const Snapshot then = live.save();
  live.push(210, {0, 0, 3}, 30);
  live.tick(300), followFully(ghost, live);
  live.restore(then);
  followFully(ghost, live);
  EXPECT_EQ(ghost.gap()->largest, 0);
  EXPECT_EQ(ghost.time(), live.time());
  live.push(30, {0, 1, 3}, 30);  // another push than the one that was taken back
  live.tick(300), followFully(ghost, live);
  EXPECT_EQ(ghost.gap()->largest, 0);
}

TEST(Ghost, BeginsAnewWithARestartAndWithAnotherScene) {
  Scene scene = poke();
  Simulation live = liveOf(scene);
  Ghost ghost(live, &findMethod("leapfrog"));
  live.tick(50), followFully(ghost, live);
  live = liveOf(scene);
  followFully(ghost, live);
  EXPECT_EQ(ghost.time(), 0);
  scene.structural.ks *= 2;
  scene.columns = 10;
  live = liveOf(scene);
  live.tick(50), followFully(ghost, live);
  EXPECT_EQ(ghost.gap()->largest, 0);
  EXPECT_EQ(ghost.positions().size(), 3U * 10 * 20);
}

TEST(Ghost, FallsBehindWhereItsTimeIsShortAndCatchesUp) {
  Simulation live = liveOf(poke());
  Ghost ghost(live, nullptr);
  double now = 0;
  const auto slowMachine = [&now] { return now += 0.1; };
  live.tick(100);
  ghost.follow(live, 0.05, slowMachine);
  EXPECT_GT(ghost.behind(), 0);
  EXPECT_FALSE(ghost.gap());
  for (int frame = 0; frame < 50 && ghost.behind() > 0; ++frame) ghost.follow(live, 0.05, slowMachine);
  EXPECT_EQ(ghost.behind(), 0);
  EXPECT_EQ(ghost.time(), live.time());
  EXPECT_TRUE(ghost.gap());
}

TEST(Ghost, IsLosingOnlyWhereTheGapDoesNotShrink) {
  Simulation live = liveOf(poke());
  Ghost ghost(live, nullptr);
  double now = 0;
  const auto slowMachine = [&now] { return now += 0.1; };
  for (int frame = 0; frame < 30; ++frame) live.tick(100), ghost.follow(live, 0.05, slowMachine);
  EXPECT_TRUE(ghost.losing());
  for (int frame = 0; frame < 30; ++frame) ghost.follow(live, 0.05, slowMachine);
  EXPECT_GT(ghost.behind(), 0);
  EXPECT_FALSE(ghost.losing());
}

TEST(Ghost, ComesUpToTheMomentShownWhereTheLiveClothHasGoneOnToItsAlarm) {
  Scene scene = poke();
  scene.dt = 0.008;
  Simulation live = liveOf(scene, "explicit-euler");
  Ghost early(live, nullptr);
  std::vector<float> positions(3 * static_cast<std::size_t>(live.sheet().count()));
  ShownTarget shown;
  for (live.tick(4); live.check() == Status::Ok; live.tick(4)) {
    followFully(early, live);
    live.copyPositions(positions);
    shown = {.ticks = live.ticks(), .time = live.time(), .positions = positions};
  }
  Ghost late(live, nullptr);
  late.follow(live, kPlenty, stillClock, &shown);
  EXPECT_EQ(late.time(), shown.time);
  EXPECT_EQ(late.behind(), 0);
  ASSERT_TRUE(late.gap());
  EXPECT_GT(late.gap()->rms, 0);
  EXPECT_NEAR(late.gap()->rms, early.gap()->rms, late.gap()->floor);
}

TEST(Ghost, ComesToAStandWhereATickTakesTooLongAndGoesOnAfterARestart) {
  Scene scene = poke();
  scene.dt = 5, scene.integrator = "backward-euler";  // thousands of the reference's steps in each tick
  Simulation live = liveOf(scene, "backward-euler");
  Ghost ghost(live, nullptr);
  double now = 0;
  live.tick(2);
  ghost.follow(live, kPlenty, [&now] { return now += 0.1; });
  EXPECT_TRUE(ghost.stalled());
  EXPECT_EQ(ghost.time(), 0);
  EXPECT_FALSE(ghost.gap());
  live = liveOf(scene, "backward-euler"), followFully(ghost, live);
  live.tick(1), followFully(ghost, live);
  EXPECT_TRUE(ghost.gap());
}

TEST(Ghost, StopsWhereItsOwnMethodFails) {
  Scene scene = poke();
  scene.dt = 0.008;  // symplectic Euler still holds, explicit Euler does not
  Simulation live = liveOf(scene, "symplectic-euler");
  Ghost ghost(live, &findMethod("explicit-euler"));
  for (int frame = 0; frame < 100; ++frame) live.tick(4), followFully(ghost, live);
  EXPECT_NE(ghost.status(), Status::Ok);
  EXPECT_GT(ghost.behind(), 0);
}

/// Undamped and thrown into folds: what is a billionth of the size at the start is seen soon.
Scene chaos() {
  Scene scene = poke();
  scene.structural = {6000, 0}, scene.shear = {2000, 0}, scene.bend = {0, 0};
  scene.gravity = {0, 3, -9};
  scene.dt = 0.001;
  return scene;
}

TEST(Ghost, SaysWhenTheHorizonHasPassed) {
  Simulation live = liveOf(chaos());
  Ghost ghost(live, nullptr);
  for (int frame = 0; frame < 60 && std::isnan(ghost.horizon()); ++frame) live.tick(100), followFully(ghost, live);
  EXPECT_GT(ghost.horizon(), 0);
  EXPECT_LT(ghost.horizon(), ghost.time());
  EXPECT_FALSE(ghost.gap()->means());
}

TEST(Ghost, SaysWhenRoundingHasMadeASecondMethodAnotherMotion) {
  Scene scene = chaos();
  scene.precision = Precision::Float;
  Simulation live = liveOf(scene);
  Ghost ghost(live, &findMethod("rk4"));
  live.tick(100), followFully(ghost, live);
  EXPECT_TRUE(ghost.gap()->means());  // two methods differ by more than rounding at first
  for (int frame = 0; frame < 60 && std::isnan(ghost.horizon()); ++frame) live.tick(100), followFully(ghost, live);
  EXPECT_GT(ghost.horizon(), 0.1);
  EXPECT_LT(ghost.horizon(), ghost.time());
}

TEST(Ghost, HasTheFloorOfTheStudy) {
  Scene scene = withSheet(chaos(), 6, 6);
  scene.precision = Precision::Float, scene.duration = 1;
  const Reference reference = makeReference(scene, 1, [](double) { return true; });
  Simulation live = liveOf(scene);
  Ghost ghost(live, nullptr);
  constexpr double kBetweenSamples = 1.5;  // the largest amplification may lie between the study's sample times
  for (const std::size_t sample : {std::size_t{4}, std::size_t{9}, std::size_t{19}}) {
    while (live.time() < reference.motion.times[sample] - scene.dt / 2) live.tick(5), followFully(ghost, live);
    const double floor = reference.floorAt(sample, Precision::Float);
    EXPECT_GT(ghost.gap()->floor, floor / kBetweenSamples) << "at " << live.time();
    EXPECT_LT(ghost.gap()->floor, floor * kBetweenSamples) << "at " << live.time();
  }
  EXPECT_GT(reference.floorOf(Precision::Float), 10 * errorFloor(reference.size, 1, 0, Precision::Float));
}

}  // namespace
}  // namespace tyg

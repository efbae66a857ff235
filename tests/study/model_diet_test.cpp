// The model diet on scenes whose answers are known, with work priced by the particle, not by a clock.
#include "study/diet/diet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

#include "study/diet/model_needs.h"
#include "study/work/cost.h"
#include "test_systems.h"
#include "tyg/methods.h"
#include "util/calibration_clock.h"

namespace tyg::test {
namespace {

/// ns: a particle costs 4, a family of springs 2 more, its damping 1, drag 1; half of all that in float.
double plainCost(const Scene& scene, int /*threads*/) {
  double each = 4 + (scene.drag > 0 ? 1 : 0);
  for (const SpringFamily& family : {scene.structural, scene.shear, scene.bend}) {
    each += (family.present() ? 2 : 0) + (family.kd > 0 ? 1 : 0);
  }
  return 1e-9 * each * scene.columns * scene.rows * (scene.precision == Precision::Float ? 0.5 : 1);
}

Diet diet(const Scene& scene, double withinOfSize = 0.01) {
  const Reference reference = makeReference(scene, 1, [](double) { return true; });
  DietPlan plan;
  plan.within = withinOfSize * reference.size;
  plan.cost = plainCost;
  return dietOf(scene, reference, plan);
}

const DietRow* find(const std::vector<DietRow>& rows, const std::string& words) {
  const auto found = std::ranges::find_if(rows, [&](const DietRow& row) { return row.words.rfind(words, 0) == 0; });
  return found == rows.end() ? nullptr : &*found;
}

Scene fallingSheet() {
  Scene scene = softSheet(Damping::Relative);
  scene.pins.clear();
  scene.drag = 0;
  scene.duration = 0.5;
  scene.dt = 0.01;
  return scene;
}

TEST(Diet, AFlatSheetInFreeFallNeedsNoSpringsAtAll) {
  constexpr double kRounding = 1e-12;  // m: half a second's fall is a metre
  const Diet found = diet(fallingSheet());
  for (const char* words : {"no structural", "no shear", "no bend", "no spring damping"}) {
    const DietRow* row = find(found.alone, words);
    ASSERT_NE(row, nullptr) << words;
    EXPECT_LT(row->lost.largest, kRounding) << words;
    EXPECT_TRUE(row->within) << words;
    EXPECT_GT(row->saved, 0.1) << words;
  }
  const Scene& lean = found.reduced().scene;
  EXPECT_FALSE(lean.structural.present() || lean.shear.present() || lean.bend.present());
}

TEST(Diet, AChainNeedsNoShearButItsDamping) {
  Scene scene = hangingChain(6, 0.1, 0.02, {200, 0.02});
  scene.shear = {200, 0.02};
  scene.pushes = {{{"bottom-left"}, {0.5, 0, 0}, 0, 0.2}};
  scene.duration = 0.5;
  scene.dt = 0.005;
  const Diet found = diet(scene, 0.005);
  const DietRow *shear = find(found.alone, "no shear"), *damping = find(found.alone, "no spring damping");
  ASSERT_TRUE(shear != nullptr && damping != nullptr);
  EXPECT_EQ(shear->lost.largest, found.written.lost.largest) << "a single column has no shear springs";
  EXPECT_TRUE(shear->within);
  EXPECT_FALSE(damping->within);
  EXPECT_FALSE(found.reduced().scene.shear.present());
  EXPECT_GT(found.reduced().scene.structural.kd, 0);
}

TEST(Diet, LeavesOutAirWindAndGustsOneAtATime) {
  Scene scene = softSheet(Damping::Relative);
  scene.air = {1.2, 1.2};
  scene.winds = {{.velocity = {4, 0, 3}, .gust = {0, 0, 2}, .wavelength = 0.5}, {.velocity = {0, 0, 1}}};
  const auto changed = [&](Change change) { return changesOf(scene, change); };
  const std::vector<Change> all = allChanges(scene);
  const auto air = std::ranges::find_if(
      all, [](const Change& change) { return change.kind == Change::LeaveOut && change.term->name == "air"; });
  ASSERT_NE(air, all.end());
  ASSERT_EQ(changed(*air).size(), 1U);
  EXPECT_EQ(changed(*air)[0].words, "no air");
  EXPECT_EQ(changed(*air)[0].scene.air.density, 0);
  for (const Change::Kind kind : {Change::StillAir, Change::SteadyWind}) {
    EXPECT_NE(std::ranges::find(all, Change{kind}), all.end());
    ASSERT_EQ(changed({kind}).size(), 1U);
    EXPECT_EQ(changed({kind})[0].scene.air, scene.air);
  }
  EXPECT_TRUE(changed({Change::StillAir})[0].scene.winds.empty());
  const std::vector<Wind> steady = changed({Change::SteadyWind})[0].scene.winds;
  ASSERT_EQ(steady.size(), 2U);
  EXPECT_EQ(steady[0].velocity, scene.winds[0].velocity);
  EXPECT_EQ(steady[0].gust, Vec3{});
  scene.winds.erase(scene.winds.begin());
  EXPECT_TRUE(changed({Change::SteadyWind}).empty()) << "there are no gusts to leave out";
  scene.winds.clear();
  EXPECT_TRUE(changed({Change::StillAir}).empty());
}

TEST(Diet, ASheetInGustsNeedsItsWind) {
  Scene scene = softSheet(Damping::Relative);
  scene.air = {1.2, 1.2};
  scene.winds = {{.velocity = {2, 0, 3}, .gust = {0, 0, 6}, .wavelength = 2}};
  scene.duration = 0.5, scene.dt = 0.005;
  const Diet found = diet(scene, 1e-3);
  for (const char* words : {"no air", "no wind", "no gusts"}) {
    const DietRow* row = find(found.alone, words);
    ASSERT_NE(row, nullptr) << words;
    EXPECT_FALSE(row->within) << words;
  }
  EXPECT_EQ(find(found.alone, "imex"), nullptr);
}

TEST(Diet, AHeavilyDampedSheetNeedsNoFourthOrder) {
  Scene scene = softSheet(Damping::Relative);
  scene.structural.kd = scene.shear.kd = scene.bend.kd = 20;
  scene.duration = 0.5;
  scene.dt = 0.01;
  const Diet found = diet(scene);
  EXPECT_LT(findMethod(found.reduced().scene.integrator).order, 4);
  EXPECT_LT(found.reduced().seconds, 0.5 * found.written.seconds);
}

TEST(Diet, EveryRowTogetherIsWithinAndCheaperThanTheOneBefore) {
  Scene scene = softSheet(Damping::Relative);
  scene.dt = 0.01;
  const Diet found = diet(scene, 0.02);
  ASSERT_FALSE(found.together.empty());
  const DietRow* before = &found.written;
  for (const DietRow& row : found.together) {
    EXPECT_TRUE(row.within) << row.words;
    EXPECT_LT(row.counted, 1.1 * before->counted) << row.words;
    EXPECT_TRUE(row.counted < 0.9 * before->counted || row.lost.rms <= before->lost.rms) << row.words;
    before = &row;
  }
  EXPECT_NEAR(found.reduced().saved, 1 - found.reduced().seconds / found.written.seconds, 1e-12);
}

/// A swinging sheet, which leapfrog keeps far better than the Euler methods at the same work.
Scene swingingSheet() {
  Scene scene = softSheet(Damping::Relative);
  scene.integrator = "rk4", scene.dt = 0.004, scene.duration = 0.4;
  return scene;
}

TEST(Diet, OfMethodsWithTheSameWorkTheMostExactIsChosenWhateverTheClockSaysOfThem) {
  const Scene scene = swingingSheet();
  const Reference reference = makeReference(scene, 1, [](double) { return true; });
  DietPlan plan;
  plan.within = 0.05 * reference.size;
  plan.cost = [](const Scene& priced, int threads) {
    return plainCost(priced, threads) * (priced.integrator == "symplectic-euler" ? 0.75 : 1);
  };
  const DietRow lean = dietOf(scene, reference, plan).reduced();
  EXPECT_EQ(lean.scene.integrator, "leapfrog") << lean.words;
}

/// Programs that compute on every core while this lives.
class Neighbours {
 public:
  Neighbours() {
    for (unsigned k = 0; k < std::max(2U, std::thread::hardware_concurrency()); ++k) {
      threads_.emplace_back([this] {
        while (!done_) {
        }
      });
    }
  }
  ~Neighbours() {
    done_ = true;
    for (std::thread& thread : threads_) thread.join();
  }
  Neighbours(const Neighbours&) = delete;
  Neighbours& operator=(const Neighbours&) = delete;

 private:
  std::atomic<bool> done_ = false;
  std::vector<std::thread> threads_;
};

TEST(Diet, IsTheSameBesideBusyNeighbours) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "the sanitizer's checks cost more than the steps whose cost is measured here";
#endif
  const Scene scene = swingingSheet();
  const Reference reference = makeReference(scene, 1, [](double) { return true; });
  const auto words = [&] {
    CostMeter meter(scene, 1, calibrationClock);
    DietPlan plan;
    plan.within = 0.05 * reference.size;
    plan.threads = 1;
    plan.cost = [&](const Scene& priced, int threads) { return meter.secondsPerUnit(priced, threads); };
    std::string all;
    for (const DietRow& row : dietOf(scene, reference, plan).together) all += row.words + "; ";
    return all;
  };
  const std::string alone = words();
  EXPECT_NE(alone.find("leapfrog"), std::string::npos) << alone;
  const Neighbours neighbours;
  EXPECT_EQ(words(), alone);
}

TEST(Diet, AZeroToleranceKeepsEverything) {
  Scene scene = softSheet(Damping::Relative);
  scene.dt = 0.01;
  const Diet found = diet(scene, 1e-9);
  EXPECT_FALSE(found.written.within) << "rk4 at a hundredth of a second is further off than that";
  EXPECT_TRUE(found.together.empty());
  EXPECT_EQ(found.reduced().scene, scene);
}

TEST(Diet, AnObserverThatSaysStopEndsIt) {
  const Scene scene = softSheet(Damping::Relative);
  const Reference reference = makeReference(scene, 1, [](double) { return true; });
  DietPlan plan;
  plan.within = 0.01;
  plan.cost = plainCost;
  plan.observer = [calls = 0](double) mutable { return ++calls < 30; };
  const Diet found = dietOf(scene, reference, plan);
  EXPECT_TRUE(found.stopped);
}

TEST(DietChanges, StayInsideTheLimitsOfTheirMethods) {
  Scene scene = softSheet(Damping::Relative);
  scene.dt = 0.01;
  for (const Change& change : allChanges(scene)) {
    for (const Changed& changed : changesOf(scene, change)) {
      EXPECT_FALSE(changed.words.empty());
      EXPECT_NE(changed.scene, scene) << changed.words;
      EXPECT_GE(changed.scene.dt, scene.dt / 4) << changed.words;
    }
  }
  scene.damping = Damping::Axial;
  for (const Changed& changed : changesOf(scene, {Change::Method})) EXPECT_NE(changed.scene.integrator, "imex");
}

TEST(ModelNeeds, AFallingSheetNeedsNothingFiner) {
  constexpr double kFallen = 1e-6;  // m: the finer sheet runs within a millionth of the size
  const Scene scene = fallingSheet();
  const Reference reference = makeReference(scene, 1, [](double) { return true; });
  const std::vector<Need> needs = needsOf(scene, reference, scene.duration, 1, [](double) { return true; });
  ASSERT_EQ(needs.size(), 2U);
  for (const Need& need : needs) EXPECT_FALSE(need.tooLean(kFallen)) << need.words << " " << need.change.rms;
}

TEST(ModelNeeds, ACoarseHangingSheetAndALongStepAreToldApart) {
  Scene scene = softSheet(Damping::Relative);
  scene.dt = 0.02;
  const Reference reference = makeReference(scene, 1, [](double) { return true; });
  const std::vector<Need> needs = needsOf(scene, reference, scene.duration, 1, [](double) { return true; });
  ASSERT_EQ(needs.size(), 2U);
  const double within = 0.005 * reference.size;
  for (const Need& need : needs) EXPECT_EQ(need.tooLean(within), need.kind == Need::Kind::Sheet) << need.words;
}

TEST(ModelNeeds, ASheetHungByTwoCornersHangsByPointsAndOneHungByAnEdgeDoesNot) {
  Scene scene = emptyWorld(4, 4);
  scene.pins = {{"top-left"}, {"top-right"}};
  EXPECT_TRUE(hangsByPoints(scene));
  scene.pins = {{"top"}};
  EXPECT_FALSE(hangsByPoints(scene));
  EXPECT_FALSE(hangsByPoints(hangingChain(4, 0.1, 1, {}))) << "a chain is held at a point and nothing else";
}

}  // namespace
}  // namespace tyg::test

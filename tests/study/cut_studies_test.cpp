// Studies of cloth that is cut or tears: limits stay safe, and what is uncertain is not compared.
#include <gtest/gtest.h>

#include <cmath>

#include "random_cloth.h"
#include "study/limits/stability.h"
#include "study/motion/error.h"
#include "study/motion/reference.h"
#include "study/motion/tearing.h"
#include "tyg/methods.h"

namespace tyg::test {
namespace {

void addRandomCuts(Scene& scene, Numbers& numbers) {
  for (int k = 0; k < 4; ++k) {
    const auto place = [&](int count) { return numbers.between(-1, count); };
    const CutLine line{place(scene.columns), place(scene.rows), place(scene.columns), place(scene.rows)};
    scene.cuts.push_back({line, scene.duration * numbers.between(0, 0.7)});
  }
}

Status statusAt(Scene scene, const Method& method, double step) {
  scene.dt = step, scene.tolerance = 0;
  Simulation simulation(scene, method, {.threads = 1});
  simulation.advanceTo(scene.duration);
  return simulation.status();
}

TEST(CutLimits, ACertifiedStepStaysSafeAfterRandomCuts) {
  Numbers numbers(3);
  for (unsigned seed = 1; seed <= 16; ++seed) {
    Scene scene = randomCloth(seed, 0.5);
    addRandomCuts(scene, numbers);
    for (const Method& method : methods()) {
      const double certified = certifiedLimit(scene, method);
      if (!(certified > 0) || !takes(method, scene)) continue;
      EXPECT_EQ(statusAt(scene, method, 0.95 * certified), Status::Ok) << method.name << " " << seed;
    }
  }
}

/// A sheet at rest that is shaken a little, cut up, and left to itself.
TEST(CutLimits, ThePredictedStepStaysSafeAfterRandomCutsAtRest) {
  Numbers numbers(8);
  for (unsigned seed = 1; seed <= 16; ++seed) {
    Scene scene = randomCloth(seed, 0.5);
    scene.gravity = {}, scene.pushes.clear(), scene.displacements.clear();
    const int count = scene.columns * scene.rows;
    for (int i = 0; i < count; ++i) {
      const Place place{"", i % scene.columns, i / scene.columns};
      scene.displacements.push_back({place, numbers.inCube(1e-6 * scene.spacing)});
    }
    addRandomCuts(scene, numbers);
    for (const Method& method : methods()) {
      const double limit = restLatticeLimit(scene, method);
      if (!(limit > 0) || !takes(method, scene) || method.name == "explicit-euler") continue;
      scene.duration = 2000 * limit;
      for (Cut& cut : scene.cuts) cut.at = std::fmod(cut.at, 0.5 * scene.duration);
      EXPECT_EQ(statusAt(scene, method, 0.95 * limit), Status::Ok) << method.name << " " << seed;
    }
  }
}

TEST(TearingStudies, EndBeforeOtherSpringsBreakAndSaySo) {
  const Scene scene = loadScene("tear");
  const Tearing tearing = untilTearsDiffer(scene, 1, {});
  ASSERT_TRUE(tearing.differs);
  EXPECT_LT(tearing.scene.duration, *tearing.differs);
  EXPECT_GE(tearing.scene.duration, scene.cuts[0].at) << "until the cut there is nothing to break";
  EXPECT_LT(*tearing.differs, 1.5);
  EXPECT_NE(tearing.words().find("certain until t = "), std::string::npos);
  const Reference reference = makeReference(tearing.scene, 1, {});
  EXPECT_TRUE(reference.usable());
  Scene other = tearing.scene;
  other.dt *= 8;
  const SampledMotion coarse = sampledRun(other, findMethod("leapfrog"), reference.motion.times);
  const auto differs = firstTornElsewhere(coarse, reference.motion);
  EXPECT_TRUE(!differs || *differs > scene.cuts[0].at);
}

TEST(TearingStudies, OfWhatIsCutOrHoldsCoverItsWholeMotion) {
  for (const char* name : {"cut", "curtain"}) {
    const Tearing tearing = untilTearsDiffer(loadScene(name), 1, {});
    EXPECT_FALSE(tearing.differs);
    EXPECT_EQ(tearing.scene, loadScene(name));
    EXPECT_EQ(tearing.words(), "");
  }
  Scene tough = loadScene("tear");
  tough.tear.toughness = 100;
  EXPECT_FALSE(untilTearsDiffer(tough, 1, {}).differs);
}

TEST(CutStudies, KnowAScenesTimedCutsAsTwoMethodsAgree) {
  const Scene scene = withSheet(loadScene("cut"), 13, 11);
  const Reference reference = makeReference(scene, 1, {});
  ASSERT_TRUE(reference.usable());
  EXPECT_LT(reference.disagreement.back(), 1e-7 * reference.size);
  EXPECT_FALSE(reference.motion.missing.back().none());
}

}  // namespace
}  // namespace tyg::test

// What a scene models and nobody will see.
#include "study/diet/idle_terms.h"

#include <gtest/gtest.h>

#include "study/motion/error.h"
#include "study/motion/sampled_motion.h"
#include "test_systems.h"
#include "tyg/methods.h"

namespace tyg::test {
namespace {

TEST(IdleTerms, ASceneWhoseEveryTermActsGetsNoNote) {
  EXPECT_TRUE(idleTerms(softSheet(Damping::Relative)).empty());
  for (const char* name : {"curtain", "flag", "poke", "hammock", "chain", "stiff", "wet", "four-particles", "spring",
                           "flutter", "drawn", "pushed-flag", "ball", "bridge", "sail", "storm", "tablecloth"}) {
    EXPECT_TRUE(idleTerms(loadScene(name)).empty()) << name << ": " << idleTerms(loadScene(name)).front();
  }
}

TEST(IdleTerms, FreeFallNeedsNoSprings) {
  const std::vector<std::string> idle = idleTerms(loadScene("drop"));
  ASSERT_EQ(idle.size(), 1U);
  EXPECT_EQ(idle[0].rfind("springs:", 0), 0U);
}

TEST(IdleTerms, EachIdleTermIsNamedAndItsAbsenceCannotBeSeen) {
  constexpr double kSeen = 1e-3;  // of the size
  Scene scene = softSheet(Damping::Relative);
  Scene fuller = scene;
  scene.drag = 0, scene.bend = {};
  fuller.drag = 1e-4 * fuller.particleMass;
  fuller.bend = {1e-4, 0};
  fuller.pushes = {{{"middle"}, {}, 0.1, 0.1}, {{"middle"}, {1, 0, 0}, 5, 1}, {{"top-left"}, {1, 0, 0}, 0, 1}};
  fuller.displacements = {{{"bottom-left"}, {}}};
  EXPECT_EQ(idleTerms(fuller).size(), 6U);
  const std::vector<double> times = sampleTimes(scene);
  const Method& method = findMethod("rk4");
  scene.dt = fuller.dt = 5e-3;
  const Distance apart = motionError(sampledRun(fuller, method, times), sampledRun(scene, method, times));
  EXPECT_LT(apart.largest, kSeen * makeSheet(scene).size());
}

TEST(IdleTerms, WindsAndMotionsWithoutEffectAreNamed) {
  Scene scene = softSheet(Damping::Relative);
  scene.air = {1.2, 1.2};
  scene.winds = {{.velocity = {1, 0, 0}}, {}, {.velocity = {1, 0, 0}, .at = 5}, {.velocity = {1, 0, 0}, .duration = 0}};
  const std::vector<Place> pin = {{"top-left"}};
  scene.moves = {{pin, {1, 0, 0}, 0, 0.1}, {pin, {}, 0, 1}, {pin, {1, 0, 0}, 5, 1}, {pin, {1, 0, 0}, 0, 0}};
  const auto count = [](const Scene& of, const char* words) {
    return std::ranges::count_if(idleTerms(of), [&](const std::string& idle) { return idle.rfind(words, 0) == 0; });
  };
  EXPECT_EQ(idleTerms(scene).size(), 6U);
  EXPECT_EQ(count(scene, "wind 1") + count(scene, "move 1"), 0);
  for (const char* words : {"wind 2", "wind 3", "wind 4", "move 2", "move 3", "move 4"}) {
    EXPECT_EQ(count(scene, words), 1) << words;
  }
  scene.winds[0].wavelength = 1;
  EXPECT_EQ(count(scene, "wind 1 has a wavelength, but no gust"), 1);
  scene.winds[0].wavelength = 0;
  scene.air.density = 0;
  EXPECT_EQ(count(scene, "wind 1"), 1);
  scene.air.density = 1.2, scene.rows = 1;
  EXPECT_EQ(count(scene, "air"), 1);
}

TEST(IdleTerms, ASheetThatFallsInAirStretchesItsSprings) {
  Scene scene = loadScene("drop");
  scene.air = {1.2, 1.2};
  EXPECT_TRUE(idleTerms(scene).empty());
}

TEST(IdleTerms, AChainHasNoShear) {
  Scene scene = hangingChain(5, 0.1, 0.01, {100, 0.1});
  scene.shear = {100, 0.1};
  ASSERT_EQ(idleTerms(scene).size(), 1U);
  EXPECT_NE(idleTerms(scene)[0].find("shear"), std::string::npos);
}

}  // namespace
}  // namespace tyg::test

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
  for (const char* name : {"curtain", "flag", "poke", "hammock", "chain", "stiff", "wet", "four-particles", "spring"}) {
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

TEST(IdleTerms, AChainHasNoShear) {
  Scene scene = hangingChain(5, 0.1, 0.01, {100, 0.1});
  scene.shear = {100, 0.1};
  ASSERT_EQ(idleTerms(scene).size(), 1U);
  EXPECT_NE(idleTerms(scene)[0].find("shear"), std::string::npos);
}

}  // namespace
}  // namespace tyg::test

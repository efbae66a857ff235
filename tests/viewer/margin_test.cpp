// The margin of a step: its bands, its words, and that it follows the simulation.
#include "viewer/margin.h"

#include <gtest/gtest.h>

#include <string>

#include "study/limits/stability.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

Margin at(double share) { return {.step = share * 0.004, .limit = 0.004}; }
std::string words(const Margin& margin) {
  MarginText text;
  describe(margin, text);
  return text.data();
}

TEST(Margin, IsCloseFromNineTenthsOnAndPastFromTheLimitOn) {
  EXPECT_EQ(at(0.5).band(), MarginBand::Fine);
  EXPECT_EQ(at(0.89).band(), MarginBand::Fine);
  EXPECT_EQ(at(0.91).band(), MarginBand::Close);
  EXPECT_EQ(at(1.01).band(), MarginBand::Past);
  EXPECT_EQ((Margin{.step = 1, .limit = 0}.band()), MarginBand::Past);
  EXPECT_EQ((Margin{.step = 1}.band()), MarginBand::None);
  EXPECT_EQ((Margin{.step = 1, .limit = 0.1, .adaptive = true}.band()), MarginBand::None);
}

TEST(Margin, SaysHowCloseAndWarnsInWords) {
  EXPECT_EQ(words(at(0.5)), "step is 50 % of the largest stable one (4 ms)");
  EXPECT_EQ(words(at(0.95)), "step is 95 % of the largest stable one (4 ms): close to unstable");
  EXPECT_EQ(words(at(14)), "14 times the largest stable step (4 ms): unstable");
  EXPECT_EQ(words({.step = 1}), "stable at any step");
  EXPECT_NE(words({.limit = 0.004, .adaptive = true}).find("own steps: on average about 4 ms"), std::string::npos);
}

TEST(Margin, FollowsMethodAndStep) {
  Simulation simulation(loadScene("curtain", methodNames()), findMethod("rk4"), {.threads = 1});
  double now = 0;
  MarginWatch watch;
  const auto update = [&] { watch.update(simulation, [&now] { return now += 1e-3; }); };
  update();
  EXPECT_EQ(watch.margin().step, 0.002);
  EXPECT_EQ(watch.margin().rest, restLatticeLimit(simulation.scene(), findMethod("rk4")));
  simulation.useStep(0.001);
  simulation.useMethod(findMethod("leapfrog"));
  update();
  EXPECT_EQ(watch.margin().step, 0.001);
  EXPECT_EQ(watch.margin().rest, restLatticeLimit(simulation.scene(), findMethod("leapfrog")));
  simulation.useMethod(findMethod("dopri54"));
  update();
  EXPECT_EQ(watch.margin().band(), MarginBand::None);
}

/// Where springs are gone a motion may have less damping for its stiffness.
TEST(Margin, OfAClothThatWasCutIsThatOfWhateverMayBeLeftUntilTheCutIsTakenBack) {
  Scene scene = loadScene("wet", methodNames());
  const Method& method = findMethod("dopri54");
  scene.tolerance = 0;
  Simulation simulation(scene, method, {.threads = 1});
  MarginWatch watch;
  const auto restNow = [&] {
    watch.update(simulation, [] { return 0.0; });
    return watch.margin().rest;
  };
  const double whole = restNow();
  EXPECT_EQ(whole, restLatticeLimit(scene, method));
  simulation.cut({4.5, -1, 4.5, 3});
  Scene cut = scene;
  cut.cuts = {{.line = {4.5, -1, 4.5, 3}, .at = 0}};
  EXPECT_EQ(restNow(), restLatticeLimit(cut, method));
  EXPECT_NE(restLatticeLimit(cut, method), whole) << "the scene does not tell";
  simulation.mend(1);
  EXPECT_EQ(restNow(), whole);
}

TEST(Margin, ShrinksWhileTheClothIsStretched) {
  Scene scene = loadScene("curtain", methodNames());
  for (SpringFamily* family : {&scene.structural, &scene.shear, &scene.bend}) family->kd = 0;
  scene.gravity = {0, -200, 0};
  scene.start = Start::Hanging;
  scene.dt = 5e-4;
  Simulation simulation(scene, findMethod("leapfrog"), {.threads = 1});
  double now = 0;
  MarginWatch watch;
  const auto ticks = [&](int count) {
    for (int tick = 0; tick < count; ++tick) {
      simulation.tick();
      watch.update(simulation, [&now] { return now += 1; });
    }
  };
  ticks(15);
  const double before = watch.margin().limit;
  EXPECT_NEAR(before, watch.margin().rest, 0.02 * before);
  ticks(400);
  EXPECT_LT(watch.margin().limit, 0.98 * before);
  EXPECT_NE(words(watch.margin()).find("at rest"), std::string::npos) << words(watch.margin());
}

TEST(Margin, TakesNoMoreThanATwentiethOfTheTimeToKnow) {
  Simulation simulation(loadScene("curtain", methodNames()), findMethod("leapfrog"), {.threads = 1});
  double now = 0, inside = 0;
  MarginWatch watch;
  for (int frame = 0; frame < 500; ++frame) {
    simulation.tick();
    now += 0.004;
    const double before = now;
    watch.update(simulation, [&now] { return now += 0.002; });  // each look at the clock finds it later
    if (now > before + 0.003) inside += 0.002;
  }
  EXPECT_GT(inside, 0);
  EXPECT_LT(inside / now, 0.06);
}

}  // namespace
}  // namespace tyg

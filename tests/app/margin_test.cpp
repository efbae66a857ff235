// The margin of a step: its bands, its words, and that it follows the simulation.
#include "app/margin.h"

#include <gtest/gtest.h>

#include <string>

#include "study/stability.h"
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
  EXPECT_EQ(words(at(0.5)), "0.50 of the limit of 4 ms");
  EXPECT_NE(words(at(0.95)).find("close"), std::string::npos);
  EXPECT_NE(words(at(1.05)).find("PAST"), std::string::npos);
}

TEST(Margin, FollowsMethodAndStep) {
  Simulation simulation(loadScene("curtain", methodNames()), findMethod("rk4"), {.threads = 1});
  double now = 0;
  MarginWatch watch;
  const auto look = [&] { watch.look(simulation, [&now] { return now += 1e-3; }); };
  look();
  EXPECT_EQ(watch.margin().step, 0.002);
  EXPECT_EQ(watch.margin().limit, restLatticeLimit(simulation.scene(), findMethod("rk4")));
  simulation.useStep(0.001);
  simulation.useMethod(findMethod("leapfrog"));
  look();
  EXPECT_EQ(watch.margin().step, 0.001);
  EXPECT_EQ(watch.margin().limit, restLatticeLimit(simulation.scene(), findMethod("leapfrog")));
  simulation.useMethod(findMethod("dopri54"));
  look();
  EXPECT_EQ(watch.margin().band(), MarginBand::None);
}

}  // namespace
}  // namespace tyg

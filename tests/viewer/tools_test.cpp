// What the left button does, without a window: pushing, and what holds for every tool of the table.
#include "viewer/tools.h"

#include <set>

#include <gtest/gtest.h>
#include "viewer/push.h"

#include "viewer/viewer_fixture.h"

namespace tyg {
namespace {

TEST_F(ViewerTest, AClickPushesTheParticleUnderTheCursorAwayFromTheEye) {
  clickOnCloth();
  ASSERT_TRUE(viewer_.tools().drawing().arrow);
  EXPECT_EQ(viewer_.tools().drawing().arrow->particle, 210);
  const Vec3 force = viewer_.tools().drawing().arrow->force;
  EXPECT_GT(glm::dot(glm::vec3(force.x, force.y, force.z), viewer_.view().camera().forward()), 0);
  EXPECT_EQ(viewer_.logLine().pushes, 1);
  EXPECT_EQ(viewer_.logLine().picked, 210);
}

TEST_F(ViewerTest, AClickStartsAWaitingCloth) {
  clickOnCloth();
  EXPECT_EQ(viewer_.run().state(), RunState::Running);
  frames(30);
  EXPECT_GT(viewer_.run().simulation().time(), 0.1);
}

TEST_F(ViewerTest, AClickFarFromTheClothPushesTheMiddleParticleAlongZAndSaysSo) {
  press(kLeftButton, 5, 700), release(kLeftButton);
  ASSERT_TRUE(viewer_.tools().drawing().arrow);
  EXPECT_EQ(viewer_.tools().drawing().arrow->particle, 210);
  EXPECT_EQ(viewer_.tools().drawing().arrow->force.x, 0);
  EXPECT_EQ(viewer_.tools().drawing().arrow->force.y, 0);
  EXPECT_GT(viewer_.tools().drawing().arrow->force.z, 0);
  EXPECT_FALSE(viewer_.notes().text().empty());
  EXPECT_EQ(viewer_.run().state(), RunState::Running);
}

TEST_F(ViewerTest, AMissByAFewPixelsPushesTheEdgeAndOneByMorePushesNothing) {
  const glm::dvec2 edge = (placeOf(380) + placeOf(381)) / 2.0;  // of the side that is nearest to the eye
  const glm::dvec2 out = glm::normalize(edge - placeOf(360));
  pressAt(edge + 30.0 * out), release(kLeftButton);
  EXPECT_EQ(viewer_.tools().record().uses, 0);
  EXPECT_FALSE(viewer_.notes().text().empty());
  EXPECT_EQ(viewer_.run().state(), RunState::Waiting);
  pressAt(edge + 7.0 * out), release(kLeftButton);
  EXPECT_EQ(viewer_.logLine().pushes, 1);
  EXPECT_TRUE(viewer_.logLine().picked == 380 || viewer_.logLine().picked == 381) << viewer_.logLine().picked;
}

TEST_F(ViewerTest, AClickFarFromTheClothPushesNothingWhereSomethingElseIsMeant) {
  press(kLeftButton, 5, 700);
  frames(60);
  release(kLeftButton);
  EXPECT_EQ(viewer_.tools().record().uses, 0) << "held for a second, it is no click";
  press(kLeftButton, 5, 700);
  viewer_.handle({.kind = Kind::Move, .x = 25, .y = 700});
  release(kLeftButton);
  EXPECT_EQ(viewer_.tools().record().uses, 0) << "a drag";
  viewer_.run().intervene().cut({-1, 5.5, 20, 5.5});
  press(kLeftButton, 5, 700), release(kLeftButton);
  EXPECT_EQ(viewer_.tools().record().uses, 0) << "the middle is of a piece that is cut off";
  EXPECT_FALSE(viewer_.notes().text().empty());
}

TEST_F(ViewerTest, AClickPushesForATenthOfASecondInWholeTicks) {
  clickOnCloth();
  const EventLog log = viewer_.run().record();
  ASSERT_EQ(log.events.size(), 1U);
  EXPECT_EQ(std::get<PushEvent>(log.events[0].action).ticks, 50);  // 0.1 s of 2 ms
}

TEST_F(ViewerTest, HoldingTheButtonStillGoesOnWithoutDoublingTheForce) {
  pressOnCloth();
  tap(' ');
  frames(30);
  release(kLeftButton);
  const EventLog log = viewer_.run().record();
  ASSERT_GT(log.events.size(), 5U);
  const auto push = [&log](std::size_t index) { return std::get<PushEvent>(log.events[index].action); };
  for (std::size_t next = 1; next < log.events.size(); ++next) {
    EXPECT_EQ(log.events[next].tick, log.events[next - 1].tick + push(next - 1).ticks);
    EXPECT_EQ(push(next).force, push(0).force);
  }
  EXPECT_EQ(viewer_.logLine().pushes, 1);
}

TEST_F(ViewerTest, StrengthMultipliesTheForceOfAClick) {
  viewer_.tools().setStrength(2);
  press(kLeftButton, 5, 700), release(kLeftButton);
  const double usual = usualPush(viewer_.run().simulation().sheet());
  EXPECT_DOUBLE_EQ(viewer_.tools().drawing().arrow->force.z, 2 * usual);
  viewer_.tools().setStrength(1e9);
  EXPECT_EQ(viewer_.tools().strength(), 100);
}

TEST_F(ViewerTest, AnArrowStaysLongEnoughToBeSeenAndThenGoes) {
  tap(' ');
  clickOnCloth();
  frames(12);
  EXPECT_TRUE(viewer_.tools().drawing().arrow) << "0.2 s: the push is over, and still shown";
  frames(12);
  EXPECT_FALSE(viewer_.tools().drawing().arrow);
}

TEST_F(ViewerTest, TheArrowStaysWhileTheButtonIsHeldHoweverLongTheFramesAre) {
  tap(' ');
  pressOnCloth();
  for (int frame = 0; frame < 10; ++frame) {
    frames(1, 0.25);  // a tenth of a simulated second each, which whole pushes fill
    EXPECT_TRUE(viewer_.tools().drawing().arrow) << frame;
  }
}

TEST_F(ViewerTest, AFrozenClothTakesNoTool) {
  viewer_.run().freeze("the driver gave up");
  clickOnCloth();
  EXPECT_EQ(viewer_.tools().record().uses, 0);
  EXPECT_TRUE(viewer_.run().record().events.empty());
}

TEST_F(ViewerTest, ARestartLetsGoOfTheCloth) {
  tap(' ');
  pressOnCloth();
  frames(15);
  tap('R'), tap(' ');
  frames(30);
  EXPECT_TRUE(viewer_.run().record().events.empty()) << "the button is still down, but not on this run";
}

TEST_F(ViewerTest, AToolIsChosenByItsNameOrKeyAndTheOneBeforeLetsGo) {
  pressOnCloth();
  tap(' ');
  frames(15);
  viewer_.tools().choose("pin");
  frames(30);
  EXPECT_LE(viewer_.run().record().events.size(), 2U) << "the button is still down, but not for this tool";
  EXPECT_TRUE(viewer_.tools().record().uses == 1 && viewer_.tools().record().picked == 210);
  tap(functionKey(4));
  EXPECT_EQ(viewer_.logLine().tool, "cut");
  tap(functionKey(2));
  EXPECT_EQ(viewer_.logLine().tool, "hand");
}

TEST_F(ViewerTest, WhatAToolLeftActingGoesOnWhenAnotherIsChosen) {
  clickOnCloth();
  viewer_.tools().choose("cut");
  EXPECT_TRUE(viewer_.tools().actsAt(49));
  EXPECT_FALSE(viewer_.tools().actsAt(50));
  EXPECT_TRUE(viewer_.tools().drawing().arrow);
}

TEST_F(ViewerTest, AnUnknownToolIsRefusedWithTheNamesOfAll) {
  try {
    viewer_.tools().choose("scissors");
    FAIL() << "there are no scissors";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "tool: found \"scissors\", allowed: hand, pin, cut");
  }
}

TEST(ToolTable, NamesEveryToolOnce) {
  std::set<std::string_view> names;
  for (const ToolKind& kind : toolTable()) {
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
    EXPECT_FALSE(kind.does.empty() || kind.how.empty() || kind.icon.empty()) << kind.name;
  }
  for (std::size_t slot = 0; slot < toolTable().size(); ++slot) EXPECT_FALSE(toolKeyName(slot).empty()) << slot;
  EXPECT_EQ(toolTable().front().name, "hand");
}

TEST_F(ViewerTest, WhatAnyToolDoesIsInTheLogAndReplaysToTheSameState) {
  for (const ToolKind& kind : toolTable()) {
    for (const bool drags : {false, true}) {
      if (kind.name == "cut" && !drags) continue;
      viewer_.tools().choose(kind.name);
      tap('R'), tap(' ');
      frames(20);
      const int uses = viewer_.tools().record().uses;
      pressOnCloth();
      if (drags) moveTo(placeOf(210) + glm::dvec2(60, 40));
      frames(15);
      release(kLeftButton);
      EXPECT_EQ(viewer_.tools().record().uses, uses + 1) << kind.name;
      frames(10);
      const EventLog log = viewer_.run().record();
      EXPECT_FALSE(log.events.empty()) << kind.name;
      Simulation again(curtain(), findMethod(log.integrator), {.threads = 1});
      again.replay(parseEventLog(formatEventLog(log), "log"), methods());
      again.tick(log.ticks);
      EXPECT_EQ(hashText(again), log.hash) << kind.name;
    }
  }
}

}  // namespace
}  // namespace tyg

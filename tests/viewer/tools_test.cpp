// What the left button does, without a window: the push tool, and what holds for every tool of the table.
#include "viewer/tools.h"

#include <set>

#include <gtest/gtest.h>
#include "viewer/push_tool.h"

#include "viewer/viewer_fixture.h"

namespace tyg {
namespace {

TEST_F(ViewerTest, AClickPushesTheParticleUnderTheCursorAwayFromTheEye) {
  clickOnCloth();
  release(kLeftButton);
  ASSERT_TRUE(viewer_.tools().drawing().arrow);
  EXPECT_EQ(viewer_.tools().drawing().arrow->particle, 210);
  const Vec3 force = viewer_.tools().drawing().arrow->force;
  EXPECT_GT(glm::dot(glm::vec3(force.x, force.y, force.z), viewer_.view().camera().forward()), 0);
  EXPECT_EQ(viewer_.logLine().pushes, 1);
  EXPECT_EQ(viewer_.logLine().picked, 210);
}

TEST_F(ViewerTest, AClickThatMissesPushesTheMiddleParticleAlongZ) {
  press(kLeftButton, 5, 700);
  ASSERT_TRUE(viewer_.tools().drawing().arrow);
  EXPECT_EQ(viewer_.tools().drawing().arrow->particle, 210);
  EXPECT_EQ(viewer_.tools().drawing().arrow->force.x, 0);
  EXPECT_EQ(viewer_.tools().drawing().arrow->force.y, 0);
  EXPECT_GT(viewer_.tools().drawing().arrow->force.z, 0);
}

TEST_F(ViewerTest, AClickPushesForATenthOfASecondInWholeTicks) {
  clickOnCloth();
  release(kLeftButton);
  const EventLog log = viewer_.run().record();
  ASSERT_EQ(log.events.size(), 1U);
  EXPECT_EQ(std::get<PushEvent>(log.events[0].action).ticks, 50);  // 0.1 s of 2 ms
}

TEST_F(ViewerTest, HoldingTheButtonGoesOnWithoutDoublingTheForce) {
  clickOnCloth();
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
  press(kLeftButton, 5, 700);
  const double usual = usualPush(viewer_.run().simulation().sheet());
  EXPECT_DOUBLE_EQ(viewer_.tools().drawing().arrow->force.z, 2 * usual);
  viewer_.tools().setStrength(1e9);
  EXPECT_EQ(viewer_.tools().strength(), 100);
}

TEST_F(ViewerTest, AnArrowStaysLongEnoughToBeSeenAndThenGoes) {
  tap(' ');
  clickOnCloth();
  release(kLeftButton);
  frames(12);
  EXPECT_TRUE(viewer_.tools().drawing().arrow) << "0.2 s: the push is over, and still shown";
  frames(12);
  EXPECT_FALSE(viewer_.tools().drawing().arrow);
}

TEST_F(ViewerTest, TheArrowStaysWhileTheButtonIsHeldHoweverLongTheFramesAre) {
  tap(' ');
  clickOnCloth();
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
  clickOnCloth();
  tap('R'), tap(' ');
  frames(30);
  EXPECT_TRUE(viewer_.run().record().events.empty()) << "the button is still down, but not on this run";
}

TEST_F(ViewerTest, AToolIsChosenByItsNameAndTheOneBeforeLetsGo) {
  clickOnCloth();
  tap(' ');
  viewer_.tools().choose("push");
  frames(30);
  EXPECT_EQ(viewer_.run().record().events.size(), 1U) << "the button is still down, but not for this tool";
  EXPECT_TRUE(viewer_.tools().record().uses == 1 && viewer_.tools().record().picked == 210);
}

TEST_F(ViewerTest, WhatAToolLeftActingGoesOnWhenAnotherIsChosen) {
  clickOnCloth();
  viewer_.tools().choose("push");
  EXPECT_TRUE(viewer_.tools().actsAt(49));
  EXPECT_FALSE(viewer_.tools().actsAt(50));
  EXPECT_TRUE(viewer_.tools().drawing().arrow);
}

TEST_F(ViewerTest, AnUnknownToolIsRefusedWithTheNamesOfAll) {
  try {
    viewer_.tools().choose("scissors");
    FAIL() << "there are no scissors";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "tool: found \"scissors\", allowed: push");
  }
}

TEST(ToolTable, NamesEveryToolOnce) {
  std::set<std::string_view> names;
  for (const ToolKind& kind : toolTable()) EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
  EXPECT_EQ(toolTable().front().name, "push");
}

TEST_F(ViewerTest, WhatAnyToolDoesIsInTheLogAndReplaysToTheSameState) {
  for (const ToolKind& kind : toolTable()) {
    const auto tool = kind.make();
    tap('R'), tap(' ');
    ToolRecord record;
    Notes notes;
    const ToolScope scope{viewer_.run(), viewer_.view(), notes, record};
    tool->press(scope, {640, 360});
    EXPECT_EQ(record.uses, 1) << kind.name;
    frames(10);
    tool->release();
    const EventLog log = viewer_.run().record();
    EXPECT_FALSE(log.events.empty()) << kind.name;
    Simulation again(curtain(), findMethod(log.integrator), {.threads = 1});
    again.replay(log, methods());
    again.tick(log.ticks);
    EXPECT_EQ(hashText(again), log.hash) << kind.name;
  }
}

}  // namespace
}  // namespace tyg

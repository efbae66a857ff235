// Keys that are held down: where they move the camera, and when they act again.
#include "viewer/held_keys.h"

#include <gtest/gtest.h>

namespace tyg {
namespace {

TEST(HeldKeys, MoveTheCameraUntilTheyAreLetGoOf) {
  HeldKeys keys;
  keys.press(*findInput('W'), 0);
  keys.press(*findInput('D'), 0);
  EXPECT_EQ(keys.motion().forward, 1);
  EXPECT_EQ(keys.motion().right, 1);
  keys.release('W');
  EXPECT_EQ(keys.motion().forward, 0);
  keys.releaseAll();
  EXPECT_FALSE(keys.moves());
}

TEST(HeldKeys, OppositeKeysCancelEachOther) {
  HeldKeys keys;
  keys.press(*findInput('Q'), 0);
  keys.press(*findInput('E'), 0);
  EXPECT_FALSE(keys.moves());
}

TEST(HeldKeys, AStepKeyActsAgainAfterAPauseAndThenQuickly) {
  HeldKeys keys;
  keys.press(*findInput(','), 10);
  EXPECT_TRUE(keys.repeats());
  EXPECT_FALSE(keys.due(10.3));
  EXPECT_EQ(keys.due(10.36), InputAction::StepBack);
  EXPECT_FALSE(keys.due(10.38));
  EXPECT_EQ(keys.due(10.42), InputAction::StepBack);
  keys.release(',');
  EXPECT_FALSE(keys.due(11));
}

TEST(HeldKeys, AKeyThatActsOnceDoesNotRepeat) {
  HeldKeys keys;
  keys.press(*findInput(' '), 0);
  EXPECT_FALSE(keys.repeats());
  EXPECT_FALSE(keys.due(100));
}

TEST(HeldKeys, AnUnknownReleaseEndsTheRepetition) {
  HeldKeys keys;
  keys.press(*findInput('['), 0);
  keys.release('{');
  EXPECT_FALSE(keys.repeats());
}

}  // namespace
}  // namespace tyg

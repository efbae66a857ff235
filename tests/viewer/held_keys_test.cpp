// Keys that are held down: where they move the camera, and when they act again.
#include "viewer/held_keys.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tyg {
namespace {

TEST(HeldKeys, MoveTheCameraUntilTheyAreLetGoOf) {
  HeldKeys keys;
  keys.press(*findInput('W'), 0);
  keys.press(*findInput('D'), 0);
  EXPECT_EQ(keys.motion().forward, 1);
  EXPECT_EQ(keys.motion().right, 1);
  keys.moved(1);
  keys.release('W');
  EXPECT_EQ(keys.motion().forward, 0);
  EXPECT_EQ(keys.motion().right, 1);
  keys.releaseAll();
  EXPECT_FALSE(keys.moves());
}

TEST(HeldKeys, ATapBetweenTwoFramesMovesForAMomentAtEveryFrameRate) {
  for (const double frame : {0.0, 1.0 / 144, 1.0 / 60, 0.2}) {
    HeldKeys keys;
    keys.press(*findInput('W'), 0);
    keys.release('W');
    double moved = 0;
    for (int k = 0; k < 100 && keys.moves(); ++k) {
      EXPECT_EQ(keys.motion().forward, 1);
      EXPECT_FALSE(keys.held(InputAction::MoveForward));
      keys.moved(k == 0 ? 0 : std::max(frame, 1e-3));  // the first frame after a rest takes no time
      moved += k == 0 ? 0 : std::max(frame, 1e-3);
    }
    EXPECT_GE(moved, 1.0 / 60 - 1e-9) << frame;
    EXPECT_LE(moved, std::max(frame, 1.0 / 60) + 1.0 / 144) << frame;
  }
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

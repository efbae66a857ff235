// Undo and redo, and the way back to the scene's own values.
#include "viewer/edits.h"

#include <gtest/gtest.h>

#include "files.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

TEST(UndoStack, WalksBackAndForthAlongTheVersions) {
  UndoStack<int> stack(1);
  stack.note(2), stack.note(3);
  EXPECT_EQ(stack.undo(), 2);
  EXPECT_EQ(stack.undo(), 1);
  EXPECT_FALSE(stack.canUndo());
  EXPECT_EQ(stack.undo(), 1);
  EXPECT_EQ(stack.redo(), 2);
  EXPECT_EQ(stack.redo(), 3);
  EXPECT_EQ(stack.redo(), 3);
}

TEST(UndoStack, AChangeForgetsWhatWasUndone) {
  UndoStack<int> stack(1);
  stack.note(2), stack.note(3);
  stack.undo();
  stack.note(7);
  EXPECT_FALSE(stack.canRedo());
  EXPECT_EQ(stack.undo(), 2);
}

TEST(UndoStack, WhatDoesNotDifferIsNoVersion) {
  UndoStack<int> stack(1);
  stack.note(1);
  EXPECT_FALSE(stack.canUndo());
  stack.note(2);
  stack.undo();
  stack.note(1);
  EXPECT_TRUE(stack.canRedo());
}

TEST(UndoStack, ForgetsTheOldestOfVeryMany) {
  UndoStack<std::size_t> stack(0);
  for (std::size_t k = 1; k < 2 * UndoStack<int>::kMost; ++k) stack.note(k);
  std::size_t steps = 0;
  while (stack.canUndo()) stack.undo(), ++steps;
  EXPECT_EQ(steps, UndoStack<int>::kMost - 1);
  EXPECT_EQ(stack.present(), UndoStack<int>::kMost);
}

class EditsTest : public testing::Test {
 protected:
  Viewer viewer_{loadScene("curtain", methodNames()), Settings{.threads = 1}, [] { return 0.0; }};
  Edits edits_{viewer_};
};

TEST_F(EditsTest, EveryKindOfChangeIsUndoneAndDoneAgain) {
  const Scene first = viewer_.scenes().scene();
  viewer_.perform(InputAction::SmallerStep), edits_.follow(viewer_);
  viewer_.scenes().use(withSheet(viewer_.scenes().scene(), 8, 6)), edits_.follow(viewer_);
  viewer_.tools().setStrength(3), edits_.follow(viewer_);
  const Scene last = viewer_.scenes().scene();
  for (int k = 0; k < 3; ++k) edits_.undo(viewer_), edits_.follow(viewer_);
  EXPECT_EQ(viewer_.scenes().scene(), first);
  EXPECT_EQ(viewer_.tools().strength(), 1);
  EXPECT_FALSE(edits_.canUndo());
  for (int k = 0; k < 3; ++k) edits_.redo(viewer_), edits_.follow(viewer_);
  EXPECT_EQ(viewer_.scenes().scene(), last);
  EXPECT_EQ(viewer_.run().simulation().sheet().count(), 48);
  EXPECT_EQ(viewer_.tools().strength(), 3);
}

TEST_F(EditsTest, ResetGoesBackToTheScenesOwnValuesAndCanItselfBeUndone) {
  const Scene first = viewer_.scenes().scene();
  Scene heavy = first;
  heavy.gravity.y *= 2;
  viewer_.scenes().use(heavy), edits_.follow(viewer_);
  edits_.reset(viewer_), edits_.follow(viewer_);
  EXPECT_EQ(viewer_.scenes().scene(), first);
  edits_.undo(viewer_);
  EXPECT_EQ(viewer_.scenes().scene(), heavy);
}

TEST_F(EditsTest, ResetTakesBackThePushAloneAsWell) {
  EXPECT_FALSE(edits_.canReset(viewer_));
  viewer_.tools().setStrength(3), edits_.follow(viewer_);
  EXPECT_TRUE(edits_.canReset(viewer_));
  edits_.reset(viewer_);
  EXPECT_EQ(viewer_.tools().strength(), 1);
  EXPECT_FALSE(edits_.canReset(viewer_));
}

TEST(Edits, AHeldKeyIsOneChange) {
  double now = 0;
  Viewer viewer(loadScene("curtain", methodNames()), Settings{.threads = 1}, [&now] { return now; });
  Edits edits(viewer);
  const double dt = viewer.scenes().scene().dt;
  viewer.handle({.kind = WindowEvent::Kind::Press, .key = ']'});
  for (int frame = 0; frame < 60; ++frame) now += 1.0 / 60, viewer.frame(), edits.follow(viewer);
  viewer.handle({.kind = WindowEvent::Kind::Release, .key = ']'});
  edits.follow(viewer);
  EXPECT_GT(viewer.scenes().scene().dt, 1.5 * dt);
  edits.undo(viewer);
  EXPECT_EQ(viewer.scenes().scene().dt, dt);
  EXPECT_FALSE(edits.canUndo());
}

TEST(Edits, WhatThePastWasSetToIsNoChange) {
  double now = 0;
  Viewer viewer(loadScene("curtain", methodNames()), Settings{.threads = 1}, [&now] { return now; });
  Edits edits(viewer);
  const auto frames = [&](int count) {
    for (int frame = 0; frame < count; ++frame) now += 1.0 / 60, viewer.frame(), edits.follow(viewer);
  };
  viewer.perform(InputAction::StartOrPause), frames(30);
  viewer.perform(InputAction::SmallerStep), frames(30);
  viewer.run().turnToTime(0.1), frames(3);
  ASSERT_TRUE(viewer.run().timeline().past);
  ASSERT_EQ(viewer.scenes().scene().dt, loadScene("curtain").dt);
  edits.undo(viewer), frames(1);
  EXPECT_FALSE(edits.canUndo());
  EXPECT_TRUE(edits.canRedo());
}

}  // namespace
}  // namespace tyg

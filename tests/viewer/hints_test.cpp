// Hints: in order, once, and away for good.
#include "viewer/hints.h"

#include <gtest/gtest.h>

#include <string>

#include "files.h"

namespace tyg {
namespace {

class HintsTest : public testing::Test {
 protected:
  const Folder folder_;
  const std::filesystem::path file_ = folder_ / "state" / "hints";
};

TEST_F(HintsTest, TheFirstHintIsToPushAndFollowingItBringsTheNext) {
  Hints hints(file_);
  const std::string first(hints.show(0));
  EXPECT_NE(first.find("pushes it"), std::string::npos);
  hints.did(Hints::Topic::Push);
  EXPECT_NE(hints.show(1), first);
  EXPECT_FALSE(hints.show(1).empty());
}

TEST_F(HintsTest, AHintThatNobodyFollowsGoesAwayByItself) {
  Hints hints(file_);
  const std::string first(hints.show(0));
  EXPECT_EQ(hints.show(Hints::kSeconds - 1), first);
  (void)hints.show(Hints::kSeconds + 1);
  EXPECT_NE(hints.show(Hints::kSeconds + 2), first);
}

TEST_F(HintsTest, WhatWasSeenDoesNotComeAgainInAnotherRun) {
  {
    Hints hints(file_);
    hints.did(Hints::Topic::Push), hints.did(Hints::Topic::Tools), hints.did(Hints::Topic::Chart),
        hints.did(Hints::Topic::Ghost);
  }
  Hints later(file_);
  EXPECT_TRUE(later.show(0).empty());
}

TEST_F(HintsTest, AFileOfAnEarlierVersionCallsAPushAPoke) {
  folder_.write("old", "poke\nunknown\n");
  Hints hints(folder_ / "old");
  EXPECT_EQ(hints.show(0).find("pushes it"), std::string_view::npos);
  EXPECT_FALSE(hints.show(0).empty()) << "the others are still to come";
}

TEST_F(HintsTest, WithoutAFileThereAreNone) {
  Hints hints(std::nullopt);
  EXPECT_TRUE(hints.show(0).empty());
  hints.did(Hints::Topic::Ghost);
}

TEST_F(HintsTest, AFolderThatCannotBeMadeOnlyBringsThemAgain) {
  folder_.write("state", "a file where a folder should be");
  Hints hints(file_);
  hints.did(Hints::Topic::Push);
  EXPECT_FALSE(hints.show(0).empty());
  EXPECT_NE(Hints(file_).show(0).find("pushes it"), std::string_view::npos);
}

}  // namespace
}  // namespace tyg

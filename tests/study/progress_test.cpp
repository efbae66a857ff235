// What the observer of a study is told.
#include "study/motion/progress.h"

#include <gtest/gtest.h>

#include <vector>

namespace tyg {
namespace {

TEST(Progress, TheObserverIsNeverToldLessThanBefore) {
  std::vector<double> told;
  Progress progress([&](double fraction) {
    told.push_back(fraction);
    return true;
  });
  progress.reach(0.3);
  progress.reach(0.2);
  progress.advanceTo(0.5);
  EXPECT_TRUE(progress.goesOn());
  EXPECT_EQ(told, (std::vector<double>{0.3, 0.3, 0.5}));
}

TEST(Progress, AStopHoldsAndTheObserverIsNotAskedAgain) {
  int calls = 0;
  Progress progress([&](double) { return ++calls < 2; });
  EXPECT_TRUE(progress.reach(0.1));
  EXPECT_FALSE(progress.reach(0.2));
  EXPECT_FALSE(progress.reach(0.3));
  EXPECT_TRUE(progress.stopped());
  EXPECT_EQ(calls, 2);
}

TEST(Progress, WithoutAnObserverNothingStops) {
  Progress progress(nullptr);
  EXPECT_TRUE(progress.reach(1));
  EXPECT_FALSE(progress.stopped());
}

}  // namespace
}  // namespace tyg

// The ring behind the running plots.
#include "viewer/running_series.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace tyg {
namespace {

void addAt(RunningSeries& series, double time) {
  const std::array<float, 2> values{float(time), float(-time)};
  series.add(time, values);
}

TEST(RunningSeries, KeepsTheLastSeconds) {
  RunningSeries series(2, 10);
  for (int k = 0; k <= 3000; ++k) addAt(series, 0.016 * k);
  ASSERT_GT(series.size(), 500U);
  EXPECT_EQ(series.time(series.size() - 1), 0.016 * 3000);
  EXPECT_GE(series.time(0), 48.0 - 10);
  EXPECT_LT(series.time(0), 48.0 - 10 + 0.02);
  for (std::size_t k = 1; k < series.size(); ++k) ASSERT_GT(series.time(k), series.time(k - 1));
  EXPECT_EQ(series.value(0, 1), -float(series.time(0)));
}

TEST(RunningSeries, LeavesOutWhatIsTooCloseToBeSeen) {
  RunningSeries series(2, 10);
  for (int k = 0; k <= 100000; ++k) addAt(series, 0.0002 * k);
  EXPECT_LE(series.size(), 1001U);
  EXPECT_GT(series.size(), 900U);
}

TEST(RunningSeries, KeepsTheFutureWhileThePastIsShownAndForgetsItWhenItIsCut) {
  RunningSeries series(2, 10);
  for (int k = 0; k <= 100; ++k) addAt(series, 0.05 * k);
  addAt(series, 2.02);
  EXPECT_EQ(series.size(), 101U);
  EXPECT_EQ(series.time(series.at(2.02)), 2.0);
  EXPECT_EQ(series.at(-1), 0U);
  series.cut(2.02);
  addAt(series, 2.04);
  EXPECT_EQ(series.time(series.size() - 1), 2.04);
  EXPECT_EQ(series.time(series.size() - 2), 2.0);
  series.cut(0);
  EXPECT_EQ(series.size(), 1U);
}

TEST(RunningSeries, BeginsAChannelAnewAndLeavesTheOthers) {
  RunningSeries series(2, 10);
  for (int k = 0; k <= 10; ++k) addAt(series, 0.05 * k);
  series.forget(1);
  addAt(series, 1);
  EXPECT_EQ(series.value(5, 0), 0.25F);
  EXPECT_TRUE(std::isnan(series.value(5, 1)));
  EXPECT_EQ(series.value(11, 1), -1.0F);
}

}  // namespace
}  // namespace tyg

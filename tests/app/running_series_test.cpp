// The ring behind the running plots.
#include "app/running_series.h"

#include <gtest/gtest.h>

#include <array>

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

TEST(RunningSeries, ForgetsTheFutureWhenTheClothGoesBack) {
  RunningSeries series(2, 10);
  for (int k = 0; k <= 100; ++k) addAt(series, 0.05 * k);
  addAt(series, 2.02);
  EXPECT_EQ(series.time(series.size() - 1), 2.02);
  EXPECT_EQ(series.time(series.size() - 2), 2.0);
  addAt(series, 0);
  EXPECT_EQ(series.size(), 1U);
}

}  // namespace
}  // namespace tyg

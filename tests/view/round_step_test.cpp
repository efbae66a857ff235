// Round steps near to given ones.
#include "view/round_step.h"

#include <gtest/gtest.h>

namespace tyg {
namespace {

TEST(RoundStep, IsOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(roundStep(1), 1);
  EXPECT_DOUBLE_EQ(roundStep(0.23), 0.2);
  EXPECT_DOUBLE_EQ(roundStep(41), 50);
  EXPECT_DOUBLE_EQ(roundStep(9e-7), 1e-6);
}

}  // namespace
}  // namespace tyg

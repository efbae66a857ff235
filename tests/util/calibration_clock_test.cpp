// The clock that costs are measured with tells bursts of a few milliseconds apart.
#include "util/calibration_clock.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tyg {
namespace {

TEST(CalibrationClock, GoesForwardInStepsShorterThanWhatIsMeasured) {
  constexpr double kShort = 1e-3;  // s; a burst takes some of them
  constexpr int kSteps = 5;
  for (const int threads : {1, 2}) {
    double shortest = 1;
    for (int step = 0; step < kSteps; ++step) {
      const double before = calibrationClock(threads);
      double now = before;
      while (now == before) now = calibrationClock(threads);
      EXPECT_GT(now, before);
      shortest = std::min(shortest, now - before);
    }
    EXPECT_LT(shortest, kShort) << threads << " threads";
  }
}

}  // namespace
}  // namespace tyg

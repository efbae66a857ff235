// The first signal raises a flag; work that cannot look at it is ended.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>

#include "util/interrupt.h"

namespace tyg::test {
namespace {

using Clock = std::chrono::steady_clock;

/// Computes for some seconds without asking.
void workDeafly() {
  for (const auto end = Clock::now() + std::chrono::seconds(20); Clock::now() < end;) {
  }
}

TEST(Interrupt, IsAFlagForThoseWhoAsk) {
  const InterruptWatch watch;
  EXPECT_FALSE(interrupted());
  std::raise(SIGTERM);
  EXPECT_TRUE(interrupted());
  for (const auto end = Clock::now() + std::chrono::milliseconds(1200); Clock::now() < end;) {
  }
  EXPECT_TRUE(interrupted());  // who has asked is left to finish
}

TEST(Interrupt, ThatNobodyAsksForEndsTheProgramWithinASecondOrTwo) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  for (const int signal : {SIGTERM, SIGINT}) {
    EXPECT_EXIT(
        {
          std::signal(signal, SIG_DFL);  // a shell's background jobs ignore SIGINT
          const InterruptWatch watch;
          std::raise(signal);
          workDeafly();
          std::exit(0);
        },
        testing::KilledBySignal(signal), "");
  }
}

}  // namespace
}  // namespace tyg::test

// Amounts with units, as people type and read them.
#include "util/amounts.h"

#include <gtest/gtest.h>

#include <limits>

#include "tyg/input_error.h"

namespace tyg {
namespace {

TEST(Amounts, OfLengthAreReadInMetresAndPerCentOfTheSize) {
  EXPECT_DOUBLE_EQ(parseLength("--within", "5mm", 2), 0.005);
  EXPECT_DOUBLE_EQ(parseLength("--within", "1.5cm", 2), 0.015);
  EXPECT_DOUBLE_EQ(parseLength("--within", "20um", 2), 20e-6);
  EXPECT_DOUBLE_EQ(parseLength("--within", "3m", 2), 3);
  EXPECT_DOUBLE_EQ(parseLength("--within", "1%", 2), 0.02);
}

TEST(Amounts, OfTimeAreReadInSeconds) {
  EXPECT_DOUBLE_EQ(parseTime("--budget", "4ms"), 0.004);
  EXPECT_DOUBLE_EQ(parseTime("--budget", "1.5s"), 1.5);
  EXPECT_DOUBLE_EQ(parseTime("--budget", "70us"), 70e-6);
  EXPECT_DOUBLE_EQ(parseTime("--at", "0", Zero::Allowed), 0);
  EXPECT_DOUBLE_EQ(parseTime("--at", "0ms", Zero::Allowed), 0);
}

TEST(Amounts, WithoutAUnitAreInMetresAndSeconds) {
  EXPECT_EQ(parseLength("--within", "0.005", 2), 0.005);
  EXPECT_EQ(parseTime("--dt", "2e-3"), 2e-3);
}

TEST(Amounts, ThatAreSharesAreNumbersOrPercentages) {
  EXPECT_DOUBLE_EQ(parseShare("--error-range", "5%"), 0.05);
  EXPECT_DOUBLE_EQ(parseShare("--ui-scale", "1.5"), 1.5);
  EXPECT_EQ(parseNumber("--fps", "30"), 30);
  EXPECT_THROW(parseNumber("--fps", "30%"), InputError);
}

TEST(Amounts, ThatAreNotANumberAboveZeroWithAKnownUnitAreRefused) {
  for (const char* text : {"", "mm", "5 mm", "5mmm", "0", "0mm", "-1mm", "nanmm", "infmm", "1e308cm1", "5ms"}) {
    EXPECT_THROW(parseLength("--within", text, 2), InputError) << text;
  }
  for (const char* text : {"", "4m", "-4ms", "0s", "4%", "1e-320us", "1e400"}) {
    EXPECT_THROW(parseTime("--budget", text), InputError) << text;
  }
  EXPECT_THROW(parseTime("--at", "-1", Zero::Allowed), InputError);
  try {
    parseTime("--budget", "4m");
    FAIL();
  } catch (const InputError& refusal) {
    EXPECT_STREQ(
        refusal.what(),
        "--budget: found '4m', allowed is a finite time above 0: seconds, or a number with us, ms or s, such as 4ms");
  }
}

TEST(Amounts, AreWrittenWithThreeDigitsAndTheUnitThatFits) {
  EXPECT_EQ(lengthText(0.0000345), "0.0345 mm");
  EXPECT_EQ(lengthText(0.028), "28 mm");
  EXPECT_EQ(lengthText(1.2), "1.2 m");
  EXPECT_EQ(lengthText(12345.6), "12346 m");
  EXPECT_EQ(timeText(12.34e-6), "12.3 us");
  EXPECT_EQ(timeText(0.004), "4 ms");
  EXPECT_EQ(timeText(1.5), "1.5 s");
  for (const double none : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(lengthText(none), "unknown");
    EXPECT_EQ(timeText(none), "unknown");
  }
}

}  // namespace
}  // namespace tyg

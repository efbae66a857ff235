// Numbers for files, and words in a list.
#include "util/text.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace tyg {
namespace {

TEST(Text, NumbersReadBackAsTheSameBits) {
  for (const double number : {0.1, 1.0 / 3, -2.5, 1e-300, 1.7976931348623157e308, 0.0}) {
    EXPECT_EQ(std::stod(longNumber(number)), number) << longNumber(number);
    EXPECT_EQ(std::stod(shortNumber(number)), number) << shortNumber(number);
  }
}

TEST(Text, ShortNumbersHaveTheFewestDigitsAndLongOnesSeventeen) {
  EXPECT_EQ(shortNumber(0.1), "0.1");
  EXPECT_EQ(longNumber(0.1), "0.10000000000000001");
  EXPECT_EQ(shortNumber(1200), "1200");
  EXPECT_EQ(shortNumber(1.0 / 3), "0.3333333333333333");
  EXPECT_EQ(longNumber(1.0 / 3), "0.33333333333333331");
}

TEST(Text, WordsAreJoinedWithCommasBetweenThem) {
  EXPECT_EQ(joined(std::vector<std::string>{}), "");
  EXPECT_EQ(joined(std::vector<std::string>{"a"}), "a");
  EXPECT_EQ(joined(std::vector<std::string>{"a", "b", "c"}), "a, b, c");
  const std::vector<std::pair<std::string, int>> pairs{{"x", 1}, {"y", 2}};
  EXPECT_EQ(joined(pairs, &std::pair<std::string, int>::first), "x, y");
}

}  // namespace
}  // namespace tyg

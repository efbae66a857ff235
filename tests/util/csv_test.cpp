// Lines of comma-separated values, written and read back.
#include "util/csv.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

namespace tyg {
namespace {

using Fields = std::vector<std::string>;

TEST(Csv, ALineHoldsTextsWholeNumbersAndNumbers) {
  EXPECT_EQ(csvLine("rk4", std::string("drop"), 3, std::int64_t{4000000000}, 0.001), "rk4,drop,3,4000000000,0.001\n");
}

TEST(Csv, AnEmptyTextIsAnEmptyField) { EXPECT_EQ(csvLine("", 1, ""), ",1,\n"); }

TEST(Csv, NumbersReadBackAsThemselves) {
  const double third = 1.0 / 3;
  EXPECT_EQ(std::stod(csvFields(csvLine(third, 2)).front()), third);
  EXPECT_EQ(csvLine(std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()), "inf,nan\n");
}

TEST(Csv, AFieldHasQuotesOnlyWhereItNeedsThem) {
  EXPECT_EQ(csvField("a flag; at rest"), "a flag; at rest");
  EXPECT_EQ(csvField("a flag, at rest"), "\"a flag, at rest\"");
  EXPECT_EQ(csvField("a \"flag\""), "\"a \"\"flag\"\"\"");
  EXPECT_EQ(csvField("two\nlines"), "\"two\nlines\"");
}

TEST(Csv, FieldsReadBackAsTheyWereWritten) {
  const Fields fields{"a, b", "", "\"", "\"quoted\", with a comma", "plain", "1e-05"};
  std::string line = csvLine(fields[0], fields[1], fields[2], fields[3], fields[4], fields[5]);
  line.pop_back();
  EXPECT_EQ(csvFields(line), fields);
}

TEST(Csv, AnEmptyLineHoldsOneEmptyField) { EXPECT_EQ(csvFields(""), Fields{""}); }

}  // namespace
}  // namespace tyg

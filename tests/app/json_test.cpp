// The text of JSON: valid whatever is in it, in the order of its keys.
#include "app/reports/json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace tyg {
namespace {

TEST(Json, KeysKeepTheirOrderAndStandOnLinesOfTheirOwn) {
  EXPECT_EQ(jsonText({{"b", 1}, {"a", {{"nested", true}}}}),
            "{\n  \"b\": 1,\n  \"a\": {\n    \"nested\": true\n  }\n}");
}

TEST(Json, StringsAreEscapedAndStayValidUtf8) {
  EXPECT_EQ(jsonText("a\"b\\c\n\t\x01"), R"("a\"b\\c\n\t\u0001")");
  EXPECT_EQ(jsonText("\u00E5"), "\"\u00E5\"");
  EXPECT_EQ(jsonText("\xE5x"), "\"\uFFFDx\"");
  EXPECT_EQ(jsonText("\x7F\xC2\x9B\xE2\x80\xAE\xF0\x9F\xBF\xBF"), R"("\u007f\u009b\u202e\ud83f\udfff")");
}

TEST(Json, NumbersReadBackAsThemselvesAndNonFiniteOnesAreNull) {
  EXPECT_EQ(jsonText(0.1), "0.1");
  EXPECT_EQ(jsonText(1e-9), "1e-09");
  EXPECT_EQ(jsonText(std::int64_t{1} << 62), "4611686018427387904");
  EXPECT_EQ(jsonText(std::nan("")), "null");
  EXPECT_EQ(jsonText(-INFINITY), "null");
}

}  // namespace
}  // namespace tyg

// Text in lines, where every letter is as wide as one.
#include "util/wrapped.h"

#include <gtest/gtest.h>

namespace tyg {
namespace {

std::string inLinesOf(float width, std::string_view text) {
  return wrapped(text, width, [](std::string_view part) { return static_cast<float>(part.size()); });
}

TEST(Wrapped, LinesBreakAtSpacesAndAreAsLongAsFits) {
  EXPECT_EQ(inLinesOf(11, "one two three four"), "one two\nthree four");
  EXPECT_EQ(inLinesOf(18, "one two three four"), "one two three four");
}

TEST(Wrapped, NumbersAndLongWordsStayWhole) {
  EXPECT_EQ(inLinesOf(8, "step of 2.86 ms"), "step of\n2.86 ms");
  EXPECT_EQ(inLinesOf(3, "a backward-euler b"), "a\nbackward-euler\nb");
}

TEST(Wrapped, LineBreaksOfTheTextStay) {
  EXPECT_EQ(inLinesOf(5, "one\ntwo three"), "one\ntwo\nthree");
  EXPECT_EQ(inLinesOf(5, ""), "");
}

TEST(Wrapped, ParagraphsCountCharactersAndIndentAllLinesButTheFirst) {
  EXPECT_EQ(paragraph("one two three", "  ", 7), "one two\n  three\n");
  EXPECT_EQ(paragraph("åäö åäö", {}, 7), "åäö åäö\n");
}

}  // namespace
}  // namespace tyg

// Texts that would do something where they are shown are shown instead.
#include "util/visible_text.h"

#include <gtest/gtest.h>

namespace tyg {
namespace {

const std::string kReplaced = "\xEF\xBF\xBD";

TEST(VisibleText, OrdinaryTextInAnyLanguageStaysAsItIs) {
  const std::string text = "Silk `$x` 'a' \"b\" <c> & #d \\ \xC3\xA9 \xE7\xB5\xB9 \xF0\x9F\xA7\xB5";
  EXPECT_EQ(oneLine(text), text);
  EXPECT_EQ(withoutActive(text), text);
}

TEST(VisibleText, LineBreaksBecomeBlanksWhereThereIsOneLine) {
  EXPECT_EQ(oneLine("a\nb\tc\r\n"), "a b c  ");
  EXPECT_EQ(withoutActive("a\nb\tc\r\n"), "a\nb\tc \n");
}

TEST(VisibleText, WhatSteersATerminalIsReplaced) {
  for (const std::string active :
       {"\x1B", "\x07", "\x7F", "\xC2\x9B", "\xE2\x80\xAE", "\xE2\x81\xA6", "\xE2\x80\xA8"}) {
    EXPECT_EQ(oneLine("a" + active + "b"), "a" + kReplaced + "b");
    EXPECT_EQ(withoutActive("a" + active + "b"), "a" + kReplaced + "b");
  }
  EXPECT_EQ(oneLine(std::string("a\0b", 3)), "a" + kReplaced + "b");
}

TEST(VisibleText, WhatXmlForbidsIsReplaced) {
  for (const std::string code : {"\xEF\xBF\xBF", "\xEF\xBF\xBE", "\xEF\xB7\x90", "\xF0\x9F\xBF\xBF"}) {
    EXPECT_EQ(oneLine(code), kReplaced);
  }
}

TEST(VisibleText, EachByteThatIsNotUtf8IsReplaced) {
  EXPECT_EQ(oneLine("a\xFF\xC3"), "a" + kReplaced + kReplaced);
  EXPECT_EQ(oneLine("\xED\xA0\x80"), kReplaced + kReplaced + kReplaced) << "a surrogate";
}

TEST(VisibleText, PathsBecomeWordsOfAShell) {
  EXPECT_EQ(shellWord("out/a-1.csv"), "out/a-1.csv");
  EXPECT_EQ(shellWord("-x"), "./-x");
  EXPECT_EQ(shellWord("a b"), "'a b'");
  EXPECT_EQ(shellWord("it's $(x)"), "'it'\\''s $(x)'");
  EXPECT_EQ(shellWord("#a"), "'#a'");
  EXPECT_EQ(shellWord(""), "''");
}

}  // namespace
}  // namespace tyg

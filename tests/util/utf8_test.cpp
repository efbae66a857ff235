// UTF-8, character by character, and bytes that are none.
#include "util/utf8.h"

#include <gtest/gtest.h>

#include <string>

namespace tyg {
namespace {

void expectFirst(std::string_view text, char32_t code, std::size_t length) {
  const Utf8Character first = firstCharacter(text);
  EXPECT_EQ(first.code, code) << text;
  EXPECT_EQ(first.length, length) << text;
}

TEST(Utf8, CharactersOfEveryLengthAreDecoded) {
  expectFirst("az", U'a', 1);
  expectFirst("\u00E5z", U'\u00E5', 2);
  expectFirst("\u20ACz", U'\u20AC', 3);
  expectFirst("\U0001F9F5z", U'\U0001F9F5', 4);
}

TEST(Utf8, WhatIsNotUtf8IsReplacedByteByByte) {
  for (const char* wrong : {"\xE5x",             // cut short by another character
                            "\xC3",              // cut short by the end
                            "\x80",              // no beginning
                            "\xC0\xAF",          // overlong
                            "\xE0\x80\xAF",      // overlong
                            "\xED\xA0\x80",      // half of a surrogate pair
                            "\xF4\x90\x80\x80",  // above the last character
                            "\xFF"}) {
    expectFirst(wrong, U'\uFFFD', 1);
  }
}

TEST(Utf8, CharactersAreCounted) {
  EXPECT_EQ(characterCount(""), 0U);
  EXPECT_EQ(characterCount("\u00E5\u20AC\U0001F9F5z"), 4U);
  EXPECT_EQ(characterCount("\xE5x"), 2U);
}

TEST(Utf8, TextIsCutBetweenCharacters) {
  EXPECT_EQ(cutToBytes("z\u20AC", 4), "z\u20AC");
  EXPECT_EQ(cutToBytes("z\u20AC", 3), "z");
  EXPECT_EQ(cutToBytes("\u20AC", 2), "");
}

}  // namespace
}  // namespace tyg

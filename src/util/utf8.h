// Stepping through UTF-8 text, character by character.
// Must not know: what the text says, how wide its letters are drawn.
#pragma once

#include <cstddef>
#include <string_view>

namespace tyg {

/// U+FFFD, which stands for what cannot be shown.
inline constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

struct Utf8Character {
  char32_t code = U'\uFFFD';  ///< the replacement character where the bytes are not UTF-8
  std::size_t length = 1;     ///< bytes that it takes; 1 where they are not UTF-8
};

/// The first character of a text that is not empty.
Utf8Character firstCharacter(std::string_view text);
/// How many characters the text has.
std::size_t characterCount(std::string_view text);
/// The longest beginning of the text that has at most this many bytes and cuts no character in two.
std::string_view cutToBytes(std::string_view text, std::size_t bytes);

}  // namespace tyg

// Goes through the text character by character; what may stay is copied byte by byte.
#include "util/visible_text.h"

#include <algorithm>
#include <array>

#include "util/utf8.h"

namespace tyg {
namespace {

struct CodeRange {
  char32_t first, last;
};
constexpr std::array<CodeRange, 6> kActive{{{0x00, 0x1F},
                                            {0x7F, 0x9F},        // the second set of control characters
                                            {0x2028, 0x2029},    // line and paragraph separators
                                            {0x202A, 0x202E},    // embeddings and overrides of direction
                                            {0x2066, 0x2069},    // isolates of direction
                                            {0xFDD0, 0xFDEF}}};  // never to be used

std::string shown(std::string_view text, bool keepsBreaks) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const Utf8Character character = firstCharacter(text);
    const bool isBreak = character.code == '\n' || character.code == '\t' || character.code == '\r';
    const bool isUnknown = character.code == U'\uFFFD';  // or bytes that are not UTF-8
    if (isBreak && (!keepsBreaks || character.code == '\r')) {
      result += ' ';
    } else if (isUnknown || (!isBreak && isActive(character.code))) {
      result += kReplacement;
    } else {
      result += text.substr(0, character.length);
    }
    text.remove_prefix(character.length);
  }
  return result;
}

}  // namespace

bool isActive(char32_t code) {
  const auto holds = [code](const CodeRange& range) { return code >= range.first && code <= range.last; };
  return std::ranges::any_of(kActive, holds) || (code & 0xFFFEU) == 0xFFFEU;  // U+FFFE, U+FFFF of every plane
}

std::string oneLine(std::string_view text) { return shown(text, false); }
std::string withoutActive(std::string_view text) { return shown(text, true); }

std::string shellWord(const std::string& path) {
  constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_./+,:@%";
  std::string safe = (path.starts_with('-') ? "./" : "") + path;
  if (!safe.empty() && safe.find_first_not_of(kPlain) == std::string::npos) return safe;
  std::string word = "'";
  for (const char character : safe) word += character == '\'' ? "'\\''" : std::string(1, character);
  return word + "'";
}

}  // namespace tyg

// Decoding as in RFC 3629: overlong forms, surrogates and numbers above 10FFFF are not UTF-8.
#include "util/utf8.h"

#include <array>

namespace tyg {
namespace {

/// A character of as many bytes begins with the bits `lead` under `mask`, and is at least `least`.
struct Form {
  unsigned mask, lead;
  std::size_t length;
  char32_t least;
};
constexpr std::array<Form, 4> kForms{
    {{0x80, 0x00, 1, 0}, {0xE0, 0xC0, 2, 0x80}, {0xF0, 0xE0, 3, 0x800}, {0xF8, 0xF0, 4, 0x10000}}};

/// Bytes after the first one of a character.
bool continues(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

}  // namespace

Utf8Character firstCharacter(std::string_view text) {
  const auto first = static_cast<unsigned char>(text.front());
  for (const Form& form : kForms) {
    if ((first & form.mask) != form.lead) continue;
    if (text.size() < form.length) return {};
    char32_t code = first & ~form.mask;
    for (const char byte : text.substr(1, form.length - 1)) {
      if (!continues(byte)) return {};
      code = code << 6U | (static_cast<unsigned char>(byte) & 0x3FU);
    }
    const bool isSurrogate = code >= 0xD800 && code <= 0xDFFF;
    if (code < form.least || code > 0x10FFFF || isSurrogate) return {};
    return {code, form.length};
  }
  return {};
}

std::size_t characterCount(std::string_view text) {
  std::size_t count = 0;
  for (; !text.empty(); ++count) text.remove_prefix(firstCharacter(text).length);
  return count;
}

std::string_view cutToBytes(std::string_view text, std::size_t bytes) {
  if (text.size() <= bytes) return text;
  while (bytes > 0 && continues(text[bytes])) --bytes;
  return text.substr(0, bytes);
}

}  // namespace tyg

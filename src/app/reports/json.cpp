// JSON output (RFC 8259).
#include "app/reports/json.h"

#include <cmath>

#include "util/text.h"

namespace tyg {
namespace {

/// How many bytes at the front of `text` form one UTF-8 character; 0 where they form none.
std::size_t characterLength(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned lead = byte(0);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return 0;
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte(k) & 0xC0U) != 0x80U) return 0;
  }
  const bool overlong = (lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xF0 && byte(1) < 0x90);
  const bool outside = (lead == 0xED && byte(1) > 0x9F) || (lead == 0xF4 && byte(1) > 0x8F);
  return overlong || outside ? 0 : length;
}

std::string escaped(char character) {
  if (character == '"' || character == '\\') return {'\\', character};
  if (character == '\n') return "\\n";
  if (character == '\t') return "\\t";
  constexpr std::string_view kDigits = "0123456789abcdef";
  const auto code = static_cast<unsigned char>(character);
  if (code >= 0x20) return {character};
  return std::string("\\u00") + kDigits[code / 16] + kDigits[code % 16];
}

}  // namespace

std::string jsonString(std::string_view text) {
  std::string literal = "\"";
  while (!text.empty()) {
    const std::size_t length = characterLength(text);
    if (length == 0) {
      literal += "\\ufffd";
    } else if (length == 1) {
      literal += escaped(text.front());
    } else {
      literal += text.substr(0, length);
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return literal + '"';
}

std::string jsonNumber(double number) {
  if (!std::isfinite(number)) return "null";
  return shortNumber(number);
}

void JsonObject::addRaw(std::string_view key, std::string_view json) {
  members_ += members_.empty() ? "\n  " : ",\n  ";
  members_.append(jsonString(key)).append(": ").append(json);
}

}  // namespace tyg

// Numbers by to_chars, which does not depend on the locale.
#include "util/text.h"

#include <array>
#include <charconv>
#include <cstdarg>
#include <cstdio>

namespace tyg {

std::string formatted(const char* format, ...) {
  std::va_list values, again;
  va_start(values, format);
  va_copy(again, values);
  std::string text(static_cast<std::size_t>(std::vsnprintf(nullptr, 0, format, values)), '\0');
  va_end(values);
  std::vsnprintf(text.data(), text.size() + 1, format, again);
  va_end(again);
  return text;
}

std::string shortNumber(double number) {
  std::array<char, 32> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr};
}

std::string longNumber(double number) {
  std::array<char, 32> digits{};
  const auto general = std::chars_format::general;
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number, general, 17).ptr};
}

}  // namespace tyg

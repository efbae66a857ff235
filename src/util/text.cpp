// Numbers by to_chars, which does not depend on the locale.
#include "util/text.h"

#include <array>
#include <charconv>

namespace tyg {

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

// Checks of option values. Numbers are read by from_chars: the same whatever the locale.
#include "app/commands/option_checks.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include <fmt/core.h>

#include "util/suggestion.h"
#include "util/text.h"

namespace tyg {
namespace {

template <class T>
std::optional<T> wholeTextAs(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string complaint(const std::string& found, const std::string& allowed) {
  return "found '" + found + "', allowed is " + allowed;
}

bool isCount(std::optional<int> number, int highest) { return number && *number >= 1 && *number <= highest; }

}  // namespace

std::string checkCount(const std::string& text, int highest, const std::string& meaning) {
  if (isCount(wholeTextAs<int>(text), highest)) return {};
  return complaint(text, fmt::format("a whole number from 1 to {}: {}", highest, meaning));
}

std::string checkOneOf(const std::string& text, const std::vector<std::string>& words) {
  return std::ranges::find(words, text) != words.end() ? "" : complaint(text, joined(words)) + didYouMean(text, words);
}

std::string checkPair(const std::string& text, int highest, const std::string& meaning) {
  const std::string_view view = text;
  const std::size_t cross = view.find('x');
  if (cross != std::string_view::npos && isCount(wholeTextAs<int>(view.substr(0, cross)), highest) &&
      isCount(wholeTextAs<int>(view.substr(cross + 1)), highest)) {
    return {};
  }
  return complaint(text, fmt::format("two whole numbers from 1 to {} with an x between: {}", highest, meaning));
}

std::pair<int, int> parsePair(const std::string& text) {
  const std::string_view view = text;
  const std::size_t cross = view.find('x');
  return {wholeTextAs<int>(view.substr(0, cross)).value(), wholeTextAs<int>(view.substr(cross + 1)).value()};
}

std::vector<std::string> splitList(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    const std::size_t first = text.find_first_not_of(" \t", from);
    if (first < comma) {
      const std::size_t last = text.find_last_not_of(" \t", comma - 1);
      parts.push_back(text.substr(first, last - first + 1));
    }
    from = comma + 1;
  }
  return parts;
}

}  // namespace tyg

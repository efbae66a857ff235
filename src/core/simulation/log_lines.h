// The text of an event log, line by line: numbers and names read from it, and refusals that say file and line.
// Must not know: what the lines mean.
#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>

#include "core/forces/parameter.h"
#include "tyg/input_error.h"

namespace tyg {

class LogLines {
 public:
  static constexpr std::int64_t kMostTicks = std::numeric_limits<std::int64_t>::max();

  /// The text and the name must outlive it.
  LogLines(std::string_view text, const std::string& fileName) : rest_(text), file_(fileName) {}

  /// Goes to the next line; says whether there was one.
  bool next() {
    if (rest_.empty()) return false;
    line_ = cut(rest_, '\n');
    if (!line_.empty() && line_.back() == '\r') line_.remove_suffix(1);
    ++number_;
    return true;
  }
  [[nodiscard]] std::string_view line() const { return line_; }

  /// Takes what is before the mark off the front of `rest`, and the mark too; everything where there is no mark.
  static std::string_view cut(std::string_view& rest, char mark) {
    const std::size_t end = rest.find(mark);
    const std::string_view first = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    return first;
  }

  [[noreturn]] void refuse(std::string_view what, std::string_view found, std::string_view allowed) const {
    throw InputError(
        fmt::format("{}:{}: {}: found '{}', allowed {}", file_, std::max(1, number_), what, found, allowed));
  }

  template <class Whole>
  [[nodiscard]] Whole whole(std::string_view what, std::string_view text, Whole lowest, Whole highest) const {
    Whole value{};
    if (!parse(text, value) || value < lowest || value > highest) {
      refuse(what, text, fmt::format("a whole number from {} to {}", lowest, highest));
    }
    return value;
  }

  [[nodiscard]] double number(std::string_view what, std::string_view text, Allowed allowed) const {
    double value = 0;
    const bool finite = parse(text, value) && std::isfinite(value);
    if (allowed == Allowed::Positive && !(finite && value > 0)) refuse(what, text, "a finite number above 0");
    if (allowed == Allowed::NotNegative && !(finite && value >= 0)) refuse(what, text, "a finite number from 0");
    if (!finite) refuse(what, text, "a finite number");
    return value;
  }

  [[nodiscard]] std::string name(std::string_view what, std::string_view text) const {
    if (text.empty()) refuse(what, text, "a name");
    return std::string(text);
  }

 private:
  template <class Number>
  static bool parse(std::string_view text, Number& value) {
    const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
    return end.ec == std::errc() && end.ptr == text.data() + text.size();
  }

  std::string_view rest_, line_;
  const std::string& file_;
  int number_ = 0;
};

}  // namespace tyg

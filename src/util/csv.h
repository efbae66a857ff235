// Comma-separated values (RFC 4180): a table is a line of column names and a line of fields for every row.
// Must not know: what the columns mean, where the text goes.
#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "util/text.h"

namespace tyg {

/// A text as one field: between quotes, with its own quotes doubled, where it holds a comma, a quote or a line break.
std::string csvField(std::string_view text);

/// One line, with its line break. Values are texts, whole numbers, or floating-point numbers, which are written as
/// shortNumber() does: the same in every locale, and they read back as the number itself.
template <class... Values>
std::string csvLine(const Values&... values) {
  const auto field = [](const auto& value) {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_floating_point_v<Value>) {
      return shortNumber(value);
    } else if constexpr (std::is_integral_v<Value>) {
      return std::to_string(value);
    } else {
      return csvField(value);
    }
  };
  std::string line;
  (line.append(field(values)).append(","), ...);
  line.back() = '\n';
  return line;
}

/// The fields of one line, given without its line break.
std::vector<std::string> csvFields(std::string_view line);

}  // namespace tyg

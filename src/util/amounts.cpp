// Numbers are read by from_chars and written by fmt: neither depends on the locale.
#include "util/amounts.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <string_view>

#include <fmt/core.h>

#include "tyg/input_error.h"

namespace tyg {
namespace {

struct Unit {
  std::string_view name;
  double worth;
};

double parsed(const std::string& option, const std::string& text, std::span<const Unit> units,
              const std::string& allowed) {
  double number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  const std::string_view unit(stop, static_cast<std::size_t>(end - stop));
  const auto found = std::ranges::find(units, unit, &Unit::name);
  if (error != std::errc() || found == units.end() || !(number > 0) || !std::isfinite(number * found->worth)) {
    throw InputError(option + ": found '" + text + "', allowed is a number above 0 with " + allowed);
  }
  return number * found->worth;
}

/// Three significant digits without an exponent where that is short.
std::string three(double number) {
  return std::abs(number) >= 1000 ? fmt::format("{:.0f}", number) : fmt::format("{:.3g}", number);
}

}  // namespace

double parseLength(const std::string& option, const std::string& text, double size) {
  const std::array<Unit, 5> units{{{"um", 1e-6}, {"mm", 1e-3}, {"cm", 1e-2}, {"m", 1}, {"%", size / 100}}};
  return parsed(option, text, units, "um, mm, cm, m or % (of the sheet's larger side), such as 5mm or 1%");
}

double parseTime(const std::string& option, const std::string& text) {
  const std::array<Unit, 3> units{{{"us", 1e-6}, {"ms", 1e-3}, {"s", 1}}};
  return parsed(option, text, units, "us, ms or s, such as 4ms");
}

std::string lengthText(double metres) {
  if (!std::isfinite(metres)) return "unknown";
  if (metres >= 1) return three(metres) + " m";
  return three(1e3 * metres) + " mm";
}

std::string timeText(double seconds) {
  if (!std::isfinite(seconds)) return "unknown";
  if (seconds >= 1) return three(seconds) + " s";
  if (seconds >= 1e-3) return three(1e3 * seconds) + " ms";
  return three(1e6 * seconds) + " us";
}

}  // namespace tyg

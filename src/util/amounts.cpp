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

/// What a kind of amount may look like.
struct Form {
  std::span<const Unit> units;
  std::string_view kind;
  std::string_view written;  ///< how it is written
  Zero zero = Zero::Refused;
};

double parsed(const std::string& option, const std::string& text, const Form& form) {
  double number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  const std::string_view unit(stop, static_cast<std::size_t>(end - stop));
  const auto found = std::ranges::find(form.units, unit, &Unit::name);
  const bool known = error == std::errc() && found != form.units.end();
  const double amount = known ? number * found->worth : 0;
  const bool inRange =
      std::isfinite(amount) && (amount > 0 || (amount == 0 && number == 0 && form.zero == Zero::Allowed));
  if (known && inRange) return amount;
  throw InputError(fmt::format("{}: found '{}', allowed is a finite {} {} 0{}", option, text, form.kind,
                               form.zero == Zero::Allowed ? "of at least" : "above", form.written));
}

/// Three significant digits without an exponent where that is short.
std::string three(double number) {
  constexpr double kLong = 1e7;
  return std::abs(number) >= 999.5 && std::abs(number) < kLong ? fmt::format("{:.0f}", number)
                                                               : fmt::format("{:.3g}", number);
}

}  // namespace

double parseLength(const std::string& option, const std::string& text, double size) {
  const std::array<Unit, 7> units{
      {{"", 1}, {"um", 1e-6}, {"µm", 1e-6}, {"mm", 1e-3}, {"cm", 1e-2}, {"m", 1}, {"%", size / 100}}};
  if (size == 0) {
    return parsed(option, text,
                  {std::span(units).first(6), "length", ": metres, or a number with um, mm, cm or m, such as 5mm"});
  }
  return parsed(
      option, text,
      {units, "length", ": metres, or a number with um, mm, cm, m or % (of the sheet's larger side), such as 5mm"});
}

double parseTime(const std::string& option, const std::string& text, Zero zero) {
  constexpr std::array<Unit, 5> kUnits{{{"", 1}, {"us", 1e-6}, {"µs", 1e-6}, {"ms", 1e-3}, {"s", 1}}};
  return parsed(option, text, {kUnits, "time", ": seconds, or a number with us, ms or s, such as 4ms", zero});
}

double parseMass(const std::string& option, const std::string& text) {
  constexpr std::array<Unit, 4> kUnits{{{"", 1}, {"mg", 1e-6}, {"g", 1e-3}, {"kg", 1}}};
  return parsed(option, text, {kUnits, "mass", ": kilograms, or a number with mg, g or kg, such as 18g"});
}

double parseShare(const std::string& option, const std::string& text) {
  constexpr std::array<Unit, 2> kUnits{{{"", 1}, {"%", 0.01}}};
  return parsed(option, text, {kUnits, "share", ": a number, or a number with %, such as 5%"});
}

double parseNumber(const std::string& option, const std::string& text, Zero zero) {
  constexpr std::array<Unit, 1> kUnits{{{"", 1}}};
  return parsed(option, text, {kUnits, "number", "", zero});
}

std::string lengthText(double metres) {
  constexpr double kBeyondReading = 1e6;
  if (!std::isfinite(metres)) return "unknown";
  if (metres >= kBeyondReading) return fmt::format("{:.2g} m", metres);
  if (metres >= 1) return three(metres) + " m";
  return three(1e3 * metres) + " mm";
}

std::string timeText(double seconds) {
  if (!std::isfinite(seconds)) return "unknown";
  constexpr double kRounded = 0.9995;  // is 1, by three digits
  if (seconds >= kRounded) return three(seconds) + " s";
  if (seconds >= 1e-3 * kRounded) return three(1e3 * seconds) + " ms";
  return three(1e6 * seconds) + " us";
}

double roundedDown(double number) {
  const double unit = std::pow(10.0, std::floor(std::log10(number)) - 1);
  return std::floor(number / unit * (1 + 1e-12)) * unit;
}

}  // namespace tyg

// Amounts with units as people type them: 5mm, 1%, 4ms. A number alone is in metres, seconds or kilograms.
// Must not know: what they are for.
#pragma once

#include <string>

namespace tyg {

enum class Zero { Refused, Allowed };
/// A length above 0 in m: a number and um, mm, cm, m or nothing, or % of `size` (m; 0: there is none). Throws
/// InputError that names the `option`.
double parseLength(const std::string& option, const std::string& text, double size);
/// A time in s: a number and us, ms, s or nothing. Throws InputError.
double parseTime(const std::string& option, const std::string& text, Zero zero = Zero::Refused);
/// A mass above 0 in kg: a number and mg, g, kg or nothing. Throws InputError.
double parseMass(const std::string& option, const std::string& text);
/// A share above 0: a number, or a number and %. Throws InputError.
double parseShare(const std::string& option, const std::string& text);
/// A number above 0 without a unit. Throws InputError.
double parseNumber(const std::string& option, const std::string& text, Zero zero = Zero::Refused);

/// A length for people, three significant digits: `0.0345 mm`, `28 mm`, `1.2 m`; `unknown` where it is not finite.
std::string lengthText(double metres);
/// A time for people: `12.3 us`, `4 ms`, `1.5 s`.
std::string timeText(double seconds);

/// Two significant digits of a number above 0, rounded down: what is advised must not lie above what was worked out.
double roundedDown(double number);

}  // namespace tyg

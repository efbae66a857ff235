// Texts of other people (titles, names of files, what another program printed) made safe to show: nothing in them can
// steer a terminal, break a line of a file, or make XML or TOML invalid. Must not know: where the text goes.
#pragma once

#include <string>
#include <string_view>

namespace tyg {

/// Whether a character does something instead of being shown: control characters, line and paragraph separators, marks
/// that turn the direction of writing around, and the codes that Unicode promises never to use.
bool isActive(char32_t code);

/// The text as UTF-8 on one line: line breaks and tabs become blanks; every other active character, and every byte that
/// is not UTF-8, becomes U+FFFD, the replacement character.
std::string oneLine(std::string_view text);
/// The same, but line breaks and tabs stay.
std::string withoutActive(std::string_view text);

/// A path as a word that a shell reads back to the same path; as it is where no character of it means anything there.
std::string shellWord(const std::string& path);

}  // namespace tyg

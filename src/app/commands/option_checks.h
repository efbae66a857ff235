// Checks of option values whose messages say what was found and what is allowed.
// Must not know: scenes, commands.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace tyg {

// Each takes the text of a value and returns an empty text where it is good, else what is wrong with it: the shape that
// CommandOption::check() wants.

/// A whole number in [1, highest].
std::string checkCount(const std::string& text, int highest, const std::string& meaning);
/// One of these words.
std::string checkOneOf(const std::string& text, const std::vector<std::string>& words);
/// Two whole numbers in [1, highest] with an x between them, such as 20x30.
std::string checkPair(const std::string& text, int highest, const std::string& meaning);

/// The two numbers of a text that checkPair() finds good.
std::pair<int, int> parsePair(const std::string& text);
/// The parts of a text between commas, without surrounding blanks; empty parts are left out.
std::vector<std::string> splitList(const std::string& text);

}  // namespace tyg

// Numbers for files, and words in a list.
// Must not know: what is written.
#pragma once

#include <functional>
#include <string>

namespace tyg {

/// A number for files, the same whatever the locale: the fewest digits that read back as the number itself, and always
/// 17 significant ones, which do too.
std::string shortNumber(double number);
std::string longNumber(double number);

/// `a, b, c`: the items, or what `wordOf` makes of each.
template <class Items, class WordOf = std::identity>
std::string joined(const Items& items, WordOf wordOf = {}) {
  std::string text;
  for (const auto& item : items) text.append(text.empty() ? "" : ", ").append(std::invoke(wordOf, item));
  return text;
}

}  // namespace tyg

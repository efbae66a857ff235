// The word that somebody probably meant, for messages that refuse another.
// Must not know: what the words are.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace tyg {

/// How many letters must be changed, added, left out or exchanged with their neighbour to make one word of the other
/// (the restricted edit distance of Damerau, 1964). Capital letters count as small ones.
std::size_t editDistance(std::string_view a, std::string_view b);

/// `; did you mean 'flag'?` for the nearest of these items, or of what `wordOf` makes of each, where one is near enough
/// to be meant; else an empty text.
template <class Items, class WordOf = std::identity>
std::string didYouMean(std::string_view found, const Items& items, WordOf wordOf = {}) {
  std::string_view nearest;
  std::size_t least = std::max<std::size_t>(1, found.size() / 3) + 1;  // a third of the letters may be wrong
  for (const auto& item : items) {
    const std::string_view word = std::invoke(wordOf, item);
    const std::size_t distance = editDistance(found, word);
    if (distance < least && distance < word.size()) least = distance, nearest = word;
  }
  return nearest.empty() ? std::string() : "; did you mean '" + std::string(nearest) + "'?";
}

}  // namespace tyg

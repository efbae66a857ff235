// One pass over the characters: quoted texts and comments are passed over as a whole, and points are counted between
// characters that no key can hold.
#include "core/scene/key_depth.h"

#include <algorithm>
#include <cctype>

namespace tyg {
namespace {

/// The index after a quoted text that begins at `from`, of one line or, between three quotes each, of many.
std::size_t afterQuoted(std::string_view text, std::size_t from) {
  const char quote = text[from];
  const bool many = text.substr(from, 3) == std::string_view{quote == '"' ? "\"\"\"" : "'''"};
  const std::string_view end = text.substr(from, many ? 3 : 1);
  for (std::size_t i = from + end.size(); i < text.size(); ++i) {
    if (text.substr(i).starts_with(end)) return i + end.size();
    if (text[i] == '\n' && !many) return i;
    if (text[i] == '\\' && quote == '"') ++i;
  }
  return text.size();
}

bool mayBeInKey(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == ' ' || c == '\t';
}

}  // namespace

int lineOfDeepKey(std::string_view text, int most) {
  int line = 1, points = 0;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t next = i + 1;
    if (text[i] == '#') {
      next = std::min(text.find('\n', i), text.size());
    } else if (text[i] == '"' || text[i] == '\'') {
      next = afterQuoted(text, i);
    } else if (text[i] == '.') {
      ++points;
    } else if (!mayBeInKey(text[i])) {
      points = 0;
    }
    if (points >= most) return line;
    line += int(std::ranges::count(text.substr(i, next - i), '\n'));
    i = next;
  }
  return 0;
}

}  // namespace tyg

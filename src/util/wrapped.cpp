// Greedy: a word goes onto the line as long as it fits.
#include "util/wrapped.h"

#include "util/utf8.h"

namespace tyg {

std::string wrapped(std::string_view text, float width, const std::function<float(std::string_view)>& widthOf) {
  std::string result(text);
  std::size_t begin = 0, space = std::string::npos;  // of the line; the last one that it can be broken at
  for (std::size_t at = 0; at <= result.size(); ++at) {
    const char next = at < result.size() ? result[at] : '\n';
    if (next != ' ' && next != '\n') continue;
    if (space != std::string::npos && widthOf(std::string_view(result).substr(begin, at - begin)) > width) {
      result[space] = '\n';
      begin = space + 1;
    }
    space = next == '\n' ? std::string::npos : at;
    if (next == '\n') begin = at + 1;
  }
  return result;
}

std::string paragraph(std::string_view text, std::string_view indent, int width) {
  std::string lines;
  for (const char character : wrapped(text, float(width), characterCount)) {
    lines += character;
    if (character == '\n') lines += indent;
  }
  return lines + "\n";
}

}  // namespace tyg

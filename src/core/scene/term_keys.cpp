// A key such as `springs.shear.ks` is split at its first and its last point.
#include "core/scene/term_keys.h"

#include <algorithm>

namespace tyg {

KeyParts partsOf(std::string_view key) {
  const std::size_t first = key.find('.'), last = key.rfind('.');
  KeyParts parts{key.substr(0, first), {}, key.substr(last + 1)};
  if (first != last) parts.inner = key.substr(first + 1, last - first - 1);
  return parts;
}

std::vector<std::string_view> tablesOfTerms() {
  std::vector<std::string_view> tables;
  for (const ForceTerm* term : forceTerms()) {
    const std::string_view table = partsOf(term->parameters.front().key).table;
    if (std::ranges::find(tables, table) == tables.end()) tables.push_back(table);
  }
  return tables;
}

}  // namespace tyg

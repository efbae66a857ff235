// One table of a scene file: gives out each key once, checked, and refuses what nobody asked for.
// Must not know: which keys a scene has.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "core/forces/parameter.h"
#include "core/scene/scene_range.h"
#include "tyg/sheet.h"

namespace tyg {

/// Every reader leaves `out` as it is where the key is absent, and throws InputError (file, line, key, found, allowed)
/// where the value is wrong.
class SceneTable {
 public:
  /// `table` and `file` must outlive this object. `prefix` is written before every key in messages: "" or "sheet.".
  SceneTable(const toml::table& table, std::string prefix, const std::string& file);

  void text(std::string_view key, std::string& out);
  void integer(std::string_view key, int& out, int lowest, int highest);
  /// A size below `smallest` is refused, unless it is 0.
  void number(std::string_view key, double& out, Allowed allowed, double smallest = kSmallestNumber);
  void vector(std::string_view key, Vec3& out);
  /// Red, green and blue, 0..1 each.
  void colour(std::string_view key, Vec3& out);
  /// A place on the grid, [column, row], as real numbers.
  void gridPoint(std::string_view key, double& column, double& row);
  /// The index of one of `names`.
  std::optional<std::size_t> oneOf(std::string_view key, std::span<const std::string_view> names);
  /// As oneOf, for an enumeration that counts up from 0 in the order of `names`.
  template <class Enumeration>
  void choice(std::string_view key, Enumeration& out, std::initializer_list<std::string_view> names) {
    if (const auto index = oneOf(key, std::span(names.begin(), names.size()))) out = static_cast<Enumeration>(*index);
  }
  void particle(std::string_view key, const Sheet& sheet, Place& out);
  void particleSets(std::string_view key, const Sheet& sheet, std::vector<Place>& out);
  /// The same, where a single particle or set may stand alone, or else the name of one of `named`, which goes to
  /// `name`.
  template <class Named>
  void particleSetsOrName(std::string_view key, const Sheet& sheet, const std::vector<Named>& named,
                          std::string Named::*nameOf, std::vector<Place>& out, std::string& name) {
    const std::optional<std::string> word = wordAt(key);
    const bool isName = word && !word->empty() && std::ranges::find(named, *word, nameOf) != named.end();
    if (isName) return text(key, name);
    std::vector<std::string_view> names;
    for (const Named& each : named) {
      if (!(each.*nameOf).empty()) names.push_back(each.*nameOf);
    }
    particleSetOrSets(key, sheet, names, out);
  }
  std::optional<SceneTable> table(std::string_view key);
  std::vector<SceneTable> tables(std::string_view key);

  [[nodiscard]] bool has(std::string_view key) const { return table_->contains(key); }
  /// To be called when every key has been asked for: refuses the others, then the absence of a required one.
  void finish(std::initializer_list<std::string_view> required = {}) const;
  /// For mistakes that involve more than one key: `key` names the line.
  [[noreturn]] void refuse(std::string_view key, const std::string& found, const std::string& allowed) const;

 private:
  /// `others` are the names that may stand here alone.
  void particleSetOrSets(std::string_view key, const Sheet& sheet, std::span<const std::string_view> others,
                         std::vector<Place>& out);
  /// Where a text is no name of particles.
  void refuseOtherName(const toml::node& value, std::span<const std::string_view> others, bool inList) const;
  /// The text there, if that is what it is.
  [[nodiscard]] std::optional<std::string> wordAt(std::string_view key) const;
  struct Asked {
    std::string_view key;
    std::string allowed;
  };
  const toml::node* ask(std::string_view key, std::string allowed);
  [[noreturn]] void refuseValue(const toml::node& value) const;
  /// Where it cannot be computed with.
  void refuseExtreme(const toml::node& value, double number, double smallest) const;
  [[noreturn]] void refuseLine(const toml::node& value, const std::string& foundAndAllowed) const;
  [[nodiscard]] Place place(const toml::node& value) const;
  [[nodiscard]] Place knownPlace(const toml::node& value, const Sheet& sheet) const;
  [[nodiscard]] SceneTable inner(std::string_view key, const toml::node& value) const;

  const toml::table* table_;
  std::string prefix_;
  const std::string* file_;
  std::vector<Asked> asked_;  ///< the last one is being read
};

}  // namespace tyg

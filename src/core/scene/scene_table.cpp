// Reads and checks the values of one TOML table; every refusal says file, line, key, found and allowed.
// Must not know: which keys a scene has.
#include "core/scene/scene_table.h"
#include "util/suggestion.h"
#include "util/text.h"
#include "util/utf8.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <utility>

namespace tyg {
namespace {

constexpr const char* kPlace = "a particle by name or as [column, row]";
constexpr const char* kPlaces = "an array of particles or sets, each by name or as [column, row]";

/// The shortest digits that mean this number, with a point where the file's number had one.
std::string textOf(double number) {
  const std::string digits = shortNumber(number);
  return digits.find_first_of(".eni") == std::string::npos ? digits + ".0" : digits;
}

/// As TOML on one line, without what is inside of tables.
std::string textOf(const toml::node& value) {
  if (value.is_table()) return "a table";
  if (value.is_floating_point()) return textOf(value.ref<double>());
  if (const toml::array* array = value.as_array()) {
    return '[' + joined(*array, [](const toml::node& element) { return textOf(element); }) + ']';
  }
  std::ostringstream out;
  value.visit([&out](const auto& known) {
    out << toml::toml_formatter{known, toml::format_flags::allow_unicode_strings};
  });
  return out.str();
}

/// Not too long for a message, and with no character cut in two.
std::string shortened(const std::string& text) {
  constexpr std::size_t kLongest = 60;
  return text.size() <= kLongest ? text : std::string(cutToBytes(text, kLongest)) + "...";
}

/// TOML has whole numbers and others; a scene takes either where a number is asked for.
std::optional<double> finiteNumber(const toml::node& value) {
  const std::optional<double> number = value.is_number() ? value.value<double>() : std::nullopt;
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<Vec3> finiteVector(const toml::node& value) {
  const toml::array* array = value.as_array();
  if (array == nullptr || array->size() != 3) return std::nullopt;
  const auto x = finiteNumber((*array)[0]), y = finiteNumber((*array)[1]), z = finiteNumber((*array)[2]);
  if (!x || !y || !z) return std::nullopt;
  return Vec3{*x, *y, *z};
}

std::string wordsFor(Allowed allowed) {
  switch (allowed) {
    case Allowed::Any:
      break;
    case Allowed::NotNegative:
      return "a finite number of at least 0";
    case Allowed::Positive:
      return "a finite number above 0";
  }
  return "a finite number";
}

bool allows(Allowed allowed, double number) {
  return allowed == Allowed::Any || number > 0 || (number == 0 && allowed == Allowed::NotNegative);
}

std::string quoted(std::span<const std::string_view> names) {
  std::string list;
  for (const std::string_view name : names) list += (list.empty() ? "\"" : ", \"") + std::string(name) + '"';
  return list;
}

}  // namespace

SceneTable::SceneTable(const toml::table& table, std::string prefix, const std::string& file)
    : table_(&table), prefix_(std::move(prefix)), file_(&file) {}

void SceneTable::text(std::string_view key, std::string& out) {
  const toml::node* value = ask(key, "a text in quotes");
  if (value == nullptr) return;
  if (!value->is_string()) refuseValue(*value);
  out = value->ref<std::string>();
}

void SceneTable::integer(std::string_view key, int& out, int lowest, int highest) {
  const toml::node* value = ask(key, fmt::format("a whole number from {} to {}", lowest, highest));
  if (value == nullptr) return;
  if (!value->is_integer()) refuseValue(*value);
  const std::int64_t number = value->ref<std::int64_t>();
  if (number < lowest || number > highest) refuseValue(*value);
  out = static_cast<int>(number);
}

void SceneTable::number(std::string_view key, double& out, Allowed allowed, double smallest) {
  const toml::node* value = ask(key, wordsFor(allowed));
  if (value == nullptr) return;
  const std::optional<double> number = finiteNumber(*value);
  if (!number || !allows(allowed, *number)) refuseValue(*value);
  refuseExtreme(*value, *number, smallest);
  out = *number;
}

void SceneTable::vector(std::string_view key, Vec3& out) {
  const toml::node* value = ask(key, "three finite numbers [x, y, z]");
  if (value == nullptr) return;
  const std::optional<Vec3> vector = finiteVector(*value);
  if (!vector) refuseValue(*value);
  for (const double part : {vector->x, vector->y, vector->z}) refuseExtreme(*value, part, 0);
  out = *vector;
}

void SceneTable::colour(std::string_view key, Vec3& out) {
  const toml::node* value = ask(key, "three numbers from 0 to 1, [red, green, blue]");
  if (value == nullptr) return;
  const std::optional<Vec3> colour = finiteVector(*value);
  if (!colour) refuseValue(*value);
  const auto [least, most] = std::minmax({colour->x, colour->y, colour->z});
  if (least < 0 || most > 1) refuseValue(*value);
  out = *colour;
}

void SceneTable::gridPoint(std::string_view key, double& column, double& row) {
  const toml::node* value = ask(key, "two finite numbers [column, row]");
  if (value == nullptr) return;
  const toml::array* array = value->as_array();
  if (array == nullptr || array->size() != 2) refuseValue(*value);
  const auto first = finiteNumber((*array)[0]), second = finiteNumber((*array)[1]);
  if (!first || !second) refuseValue(*value);
  for (const double part : {*first, *second}) refuseExtreme(*value, part, 0);
  column = *first, row = *second;
}

std::optional<std::size_t> SceneTable::oneOf(std::string_view key, std::span<const std::string_view> names) {
  const toml::node* value = ask(key, quoted(names));
  if (value == nullptr) return std::nullopt;
  if (!value->is_string()) refuseValue(*value);
  const auto found = std::find(names.begin(), names.end(), value->ref<std::string>());
  if (found == names.end()) {
    asked_.back().allowed += didYouMean(value->ref<std::string>(), names);
    refuseValue(*value);
  }
  return static_cast<std::size_t>(found - names.begin());
}

Place SceneTable::place(const toml::node& value) const {
  if (value.is_string() && !value.ref<std::string>().empty()) return {value.ref<std::string>(), 0, 0};
  const toml::array* array = value.as_array();
  if (array == nullptr || array->size() != 2) refuseValue(value);
  if (!array->is_homogeneous<std::int64_t>()) refuseValue(value);
  const std::int64_t column = (*array)[0].ref<std::int64_t>(), row = (*array)[1].ref<std::int64_t>();
  if (!std::in_range<int>(column) || !std::in_range<int>(row)) refuseValue(value);
  return {"", static_cast<int>(column), static_cast<int>(row)};
}

void SceneTable::particle(std::string_view key, const Sheet& sheet, Place& out) {
  const toml::node* value = ask(key, kPlace);
  if (value == nullptr) return;
  out = place(*value);
  try {
    (void)particleAt(sheet, out);
  } catch (const InputError& mistake) {
    refuseLine(*value, mistake.what());
  }
}

void SceneTable::particleSets(std::string_view key, const Sheet& sheet, std::vector<Place>& out) {
  const toml::node* value = ask(key, kPlaces);
  if (value == nullptr) return;
  const toml::array* array = value->as_array();
  if (array == nullptr) refuseValue(*value);
  std::set<std::string> names;  // a set of particles is listed once, however often it is named
  for (const toml::node& element : *array) {
    const bool isNew = !element.is_string() || names.insert(element.ref<std::string>()).second;
    out.push_back(isNew ? knownPlace(element, sheet) : place(element));
  }
}

void SceneTable::particleSetOrSets(std::string_view key, const Sheet& sheet, std::span<const std::string_view> others,
                                   std::vector<Place>& out) {
  const toml::node* value = ask(key, kPlaces);
  if (value == nullptr) return;
  const auto take = [&](const toml::node& element, bool inList) {
    refuseOtherName(element, others, inList);
    out.push_back(knownPlace(element, sheet));
  };
  const toml::array* array = value->as_array();
  if (array != nullptr && array->empty()) refuseLine(*value, "found [], allowed one particle or set at least");
  if (array == nullptr || array->is_homogeneous<std::int64_t>()) return take(*value, false);
  for (const toml::node& element : *array) take(element, true);
}

void SceneTable::refuseOtherName(const toml::node& value, std::span<const std::string_view> others, bool inList) const {
  if (!value.is_string() || value.ref<std::string>().empty()) return;
  const std::string& word = value.ref<std::string>();
  if (isPlaceName(word)) return;
  if (inList && std::ranges::find(others, word) != others.end()) {
    refuseLine(value, fmt::format("found \"{0}\" in a list, allowed \"{0}\" by itself: a body stands alone", word));
  }
  const std::span<const std::string_view> places = placeNames();
  std::vector<std::string_view> names(places.begin(), places.end());
  if (!inList) names.insert(names.end(), others.begin(), others.end());
  refuseLine(value, fmt::format("found {}, the name of nothing in this scene, allowed {}, [column, row]{}",
                                shortened(textOf(value)), quoted(names), didYouMean(word, names)));
}

std::optional<std::string> SceneTable::wordAt(std::string_view key) const {
  const toml::node* value = table_->get(key);
  return value == nullptr ? std::nullopt : value->value_exact<std::string>();
}

Place SceneTable::knownPlace(const toml::node& value, const Sheet& sheet) const {
  Place found = place(value);
  try {
    (void)particlesAt(sheet, found);
  } catch (const InputError& mistake) {
    refuseLine(value, mistake.what());
  }
  return found;
}

std::optional<SceneTable> SceneTable::table(std::string_view key) {
  const toml::node* value = ask(key, "a table");
  if (value == nullptr) return std::nullopt;
  if (value->is_array_of_tables()) {
    refuseLine(*value, fmt::format("found a list of tables, [[{0}{1}]], allowed one table, [{0}{1}]", prefix_, key));
  }
  return inner(key, *value);
}

std::vector<SceneTable> SceneTable::tables(std::string_view key) {
  std::vector<SceneTable> all;
  const toml::node* value = ask(key, "tables, each under [[" + prefix_ + std::string(key) + "]]");
  if (value == nullptr) return all;
  const toml::array* array = value->as_array();
  if (array == nullptr) refuseValue(*value);
  for (const toml::node& element : *array) all.push_back(inner(key, element));
  return all;
}

SceneTable SceneTable::inner(std::string_view key, const toml::node& value) const {
  const toml::table* table = value.as_table();
  if (table == nullptr) refuseValue(value);
  return {*table, prefix_ + std::string(key) + '.', *file_};
}

void SceneTable::finish(std::initializer_list<std::string_view> required) const {
  std::vector<std::string_view> known;
  for (const Asked& asked : asked_) known.push_back(asked.key);
  for (const auto& [key, value] : *table_) {
    if (std::find(known.begin(), known.end(), key.str()) == known.end()) {
      refuse(key.str(), value.is_table() ? "an unknown table" : "an unknown key",
             quoted(known) + didYouMean(key.str(), known));
    }
  }
  for (const Asked& asked : asked_) {
    const bool needed = std::find(required.begin(), required.end(), asked.key) != required.end();
    if (needed && !has(asked.key)) refuse(asked.key, "nothing, and it is required", asked.allowed);
  }
}

void SceneTable::refuse(std::string_view key, const std::string& found, const std::string& allowed) const {
  const auto at = table_->find(key);
  const toml::source_region& source = at == table_->end() ? table_->source() : at->first.source();
  throw InputError(
      fmt::format("{}:{}: key {}{}: found {}, allowed {}", *file_, source.begin.line, prefix_, key, found, allowed));
}

const toml::node* SceneTable::ask(std::string_view key, std::string allowed) {
  asked_.push_back({key, std::move(allowed)});
  return table_->get(key);
}

void SceneTable::refuseValue(const toml::node& value) const {
  refuseLine(value, fmt::format("found {}, allowed {}", shortened(textOf(value)), asked_.back().allowed));
}

void SceneTable::refuseExtreme(const toml::node& value, double number, double smallest) const {
  const double size = std::abs(number);
  if (number == 0 || (size >= smallest && size <= kLargestNumber)) return;
  refuseLine(value, fmt::format("found {}, allowed are numbers of a size from {:g} to {:g}", shortened(textOf(value)),
                                kSmallestNumber, kLargestNumber));
}

void SceneTable::refuseLine(const toml::node& value, const std::string& foundAndAllowed) const {
  throw InputError(fmt::format("{}:{}: key {}{}: {}", *file_, value.source().begin.line, prefix_, asked_.back().key,
                               foundAndAllowed));
}

}  // namespace tyg

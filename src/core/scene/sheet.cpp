// The sheet at rest: names and places of particles, start shapes, and the springs as pairs.
// Must not know: the moving state, forces, methods.
#include "tyg/sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <string_view>

#include "core/scene/springs_of_particle.h"
#include "util/suggestion.h"

namespace tyg {
namespace {

constexpr std::array<std::string_view, 8> kNames{"top-left", "top-right", "bottom-left", "bottom-right",
                                                 "middle",   "top",       "left",        "corners"};
constexpr std::size_t kSingles = 5;  // of these names are of one particle, the others of sets

int indexOf(const Sheet& sheet, int column, int row) { return row * sheet.columns + column; }

/// The particle of that name, or -1.
int namedParticle(const Sheet& sheet, const std::string& name) {
  const int right = sheet.columns - 1, bottom = sheet.rows - 1;
  if (name == "top-left") return indexOf(sheet, 0, 0);
  if (name == "top-right") return indexOf(sheet, right, 0);
  if (name == "bottom-left") return indexOf(sheet, 0, bottom);
  if (name == "bottom-right") return indexOf(sheet, right, bottom);
  if (name == "middle") return indexOf(sheet, sheet.columns / 2, sheet.rows / 2);
  return -1;
}

/// The particles of the set of that name; none where there is no such set.
std::vector<int> namedSet(const Sheet& sheet, const std::string& name) {
  const int right = sheet.columns - 1, bottom = sheet.rows - 1;
  std::vector<int> particles;
  if (name == "top") {
    for (int column = 0; column <= right; ++column) particles.push_back(indexOf(sheet, column, 0));
  } else if (name == "left") {
    for (int row = 0; row <= bottom; ++row) particles.push_back(indexOf(sheet, 0, row));
  } else if (name == "corners") {
    particles = {indexOf(sheet, 0, 0), indexOf(sheet, right, 0), indexOf(sheet, 0, bottom),
                 indexOf(sheet, right, bottom)};
  }
  return particles;
}

int numberedParticle(const Sheet& sheet, const Place& place) {
  const bool inside = place.column >= 0 && place.column < sheet.columns && place.row >= 0 && place.row < sheet.rows;
  if (!inside) {
    throw InputError(fmt::format("found particle [{}, {}], allowed columns 0 to {} and rows 0 to {}", place.column,
                                 place.row, sheet.columns - 1, sheet.rows - 1));
  }
  return indexOf(sheet, place.column, place.row);
}

[[noreturn]] void refuseName(const Place& place, std::span<const std::string_view> names) {
  throw InputError(fmt::format("found particle \"{}\", allowed \"{}\", [column, row]{}", place.name,
                               fmt::join(names, "\", \""), didYouMean(place.name, names)));
}

/// A family's springs as steps on the grid: from (c, r) to (c + columns, r + rows).
struct GridStep {
  int columns, rows;
};

std::array<GridStep, 2> gridSteps(Family family) {
  switch (family) {
    case Family::Structural:
      return {{{1, 0}, {0, 1}}};
    case Family::Shear:
      return {{{1, 1}, {-1, 1}}};
    case Family::Bend:
      break;
  }
  return {{{2, 0}, {0, 2}}};
}

/// The spring of a family from particle (column, row) by this step; the second diagonal belongs to the cell's first
/// particle.
bool isMissing(const Sheet& sheet, int column, int row, const GridStep& step, Family family) {
  if (sheet.missing.none()) return false;
  for (const SpringOfParticle& spring : kSpringsOfParticle) {
    if (spring.family != family || spring.toRow != step.rows) continue;
    if (spring.toColumn - spring.fromColumn != step.columns) continue;
    return sheet.missing.has(indexOf(sheet, column - spring.fromColumn, row), spring.bit);
  }
  return false;
}

}  // namespace

double Sheet::size() const {
  const int longest = std::max(columns, rows);
  return longest > 1 ? (longest - 1) * spacing : spacing;
}

Vec3 Sheet::startPosition(int particle) const {
  const int column = particle % columns, row = particle / columns;
  const double x = (column - (columns - 1) / 2.0) * spacing;
  const double down = row * spacing;
  return start == Start::Hanging ? Vec3{x, -down, 0} : Vec3{x, 0, down};
}

Sheet makeSheet(const Scene& scene) {
  Sheet sheet{scene.columns, scene.rows, scene.spacing, scene.particleMass, scene.start, {}};
  std::set<std::string_view> names;  // a set of particles is listed once, however often it is named
  for (const Place& pin : scene.pins) {
    if (!pin.name.empty() && !names.insert(pin.name).second) continue;
    const std::vector<int> particles = particlesAt(sheet, pin);
    sheet.pins.insert(sheet.pins.end(), particles.begin(), particles.end());
  }
  std::sort(sheet.pins.begin(), sheet.pins.end());
  sheet.pins.erase(std::unique(sheet.pins.begin(), sheet.pins.end()), sheet.pins.end());
  return sheet;
}

bool isPlaceName(std::string_view word) { return std::ranges::find(kNames, word) != kNames.end(); }

std::span<const std::string_view> placeNames() { return kNames; }

std::span<const std::string_view> particleNames() { return std::span(kNames).first(kSingles); }

int particleAt(const Sheet& sheet, const Place& place) {
  if (place.name.empty()) return numberedParticle(sheet, place);
  const int particle = namedParticle(sheet, place.name);
  if (particle < 0) refuseName(place, particleNames());
  return particle;
}

std::vector<int> particlesAt(const Sheet& sheet, const Place& place) {
  if (place.name.empty()) return {numberedParticle(sheet, place)};
  const int particle = namedParticle(sheet, place.name);
  if (particle >= 0) return {particle};
  std::vector<int> particles = namedSet(sheet, place.name);
  if (particles.empty()) refuseName(place, kNames);
  return particles;
}

std::vector<SpringEnds> springsOf(const Sheet& sheet, Family family) {
  std::vector<SpringEnds> springs;
  for (int row = 0; row < sheet.rows; ++row) {
    for (int column = 0; column < sheet.columns; ++column) {
      for (const GridStep& step : gridSteps(family)) {
        const int otherColumn = column + step.columns, otherRow = row + step.rows;
        const bool inside = otherColumn >= 0 && otherColumn < sheet.columns && otherRow < sheet.rows;
        if (!inside || isMissing(sheet, column, row, step, family)) continue;
        springs.push_back({indexOf(sheet, column, row), indexOf(sheet, otherColumn, otherRow)});
      }
    }
  }
  return springs;
}

long long springCount(const Sheet& sheet, Family family) {
  if (!sheet.missing.none()) return static_cast<long long>(springsOf(sheet, family).size());
  long long count = 0;
  for (const GridStep& step : gridSteps(family)) {
    count += static_cast<long long>(std::max(0, sheet.columns - std::abs(step.columns))) *
             std::max(0, sheet.rows - step.rows);
  }
  return count;
}

double restLength(const Sheet& sheet, Family family) {
  switch (family) {
    case Family::Structural:
      return sheet.spacing;
    case Family::Shear:
      return sheet.spacing * std::sqrt(2.0);
    case Family::Bend:
      break;
  }
  return 2 * sheet.spacing;
}

}  // namespace tyg

// What a straight cut takes from a grid: every spring near it is held against its line. And when cloth tears.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/scene/springs_of_particle.h"
#include "tyg/sheet.h"

namespace tyg {
namespace {

struct GridPoint {
  double column = 0, row = 0;
};

/// > 0 where c lies to one side of the line from a to b, < 0 on the other one.
double side(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  return (b.column - a.column) * (c.row - a.row) - (b.row - a.row) * (c.column - a.column);
}

class Blade {
 public:
  explicit Blade(const CutLine& cut) : from_{cut.fromColumn, cut.fromRow}, to_{cut.toColumn, cut.toRow} {
    // So that the positive side has the larger columns, or along a row the larger rows.
    const bool turns = from_.row == to_.row ? to_.column < from_.column : to_.row > from_.row;
    if (turns) std::swap(from_, to_);
  }

  [[nodiscard]] bool takes(const GridPoint& a, const GridPoint& b) const {
    if ((side(from_, to_, a) >= 0) == (side(from_, to_, b) >= 0)) return false;
    const double first = side(a, b, from_), last = side(a, b, to_);
    return !(first > 0 && last > 0) && !(first < 0 && last < 0);
  }

 private:
  GridPoint from_, to_;
};

/// The whole numbers from 0 to below `count` that are nearer than three to what lies between two numbers.
struct Stretch {
  int first = 0, last = 0;
  Stretch(double a, double b, int count)
      : first(int(std::clamp(std::floor(std::min(a, b)) - 3, 0.0, double(count)))),
        last(int(std::clamp(std::ceil(std::max(a, b)) + 3, 0.0, double(count)))) {}
};

}  // namespace

/// A toughness per length of tear, and not a largest strain, so that a finer grid of the same cloth tears alike (crack
/// band, Bazant and Oh 1983): a spring that breaks held toughness times spacing.
double strainThatTears(const Scene& scene) {
  if (!(scene.tear.toughness > 0)) return std::numeric_limits<double>::infinity();
  return std::sqrt(2 * scene.tear.toughness / (scene.structural.ks * scene.spacing));
}

bool losesSprings(const Scene& scene) { return !scene.cuts.empty() || std::isfinite(strainThatTears(scene)); }

bool Missing::anyIn(int firstParticle, int columns) const {
  if (!bits_) return false;
  const auto first = bits_->begin() + firstParticle;
  return std::any_of(first, first + columns, [](std::uint8_t bits) { return bits != 0; });
}

std::uint64_t Missing::mixedInto(std::uint64_t hash) const {
  if (!bits_) return hash;
  for (const std::uint8_t bits : *bits_) hash = (hash ^ bits) * 1099511628211U;
  return hash;
}

bool Missing::operator==(const Missing& other) const {
  return bits_ == other.bits_ || (bits_ && other.bits_ && *bits_ == *other.bits_);
}

Missing Missing::withCut(int columns, int rows, const CutLine& cut) const {
  const Blade blade(cut);
  std::vector<std::uint8_t> bits = bits_ ? *bits_ : std::vector<std::uint8_t>(std::size_t(columns) * std::size_t(rows));
  const Stretch across(cut.fromColumn, cut.toColumn, columns), down(cut.fromRow, cut.toRow, rows);
  bool takes = false;
  for (int row = down.first; row < down.last; ++row) {
    for (int column = across.first; column < across.last; ++column) {
      std::uint8_t& own = bits[std::size_t(row) * std::size_t(columns) + std::size_t(column)];
      for (const SpringOfParticle& spring : kSpringsOfParticle) {
        if (!isInside(spring, column, row, columns, rows)) continue;
        const GridPoint a{double(column + spring.fromColumn), double(row)};
        const GridPoint b{double(column + spring.toColumn), double(row + spring.toRow)};
        if (!blade.takes(a, b)) continue;
        const bool isDiagonal = spring.bit == DownRight || spring.bit == DownLeft;
        own = std::uint8_t(own | spring.bit | (isDiagonal ? Cell : 0));
        takes = true;
      }
    }
  }
  if (!takes) return *this;
  Missing missing;
  missing.bits_ = std::make_shared<const std::vector<std::uint8_t>>(std::move(bits));
  return missing;
}

}  // namespace tyg

// Goes through the springs of a family row by row without a list of them.
#include "view/stretch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tyg {
namespace {

/// From a particle to the other end of a spring, and the bit that says that it is gone, of the particle `from` it.
struct Offset {
  int columns, rows;
  Missing::Bit bit;
  int from = 0;
};

std::array<Offset, 2> offsetsOf(Family family) {
  switch (family) {
    case Family::Structural:
      return {{{1, 0, Missing::Right}, {0, 1, Missing::Down}}};
    case Family::Shear:
      return {{{1, 1, Missing::DownRight}, {-1, 1, Missing::DownLeft, -1}}};
    default:
      return {{{2, 0, Missing::Right2}, {0, 2, Missing::Down2}}};
  }
}

}  // namespace

Stretch stretchOf(const Sheet& sheet, std::span<const float> xyz, Family family) {
  const double rest = restLength(sheet, family);
  double sum = 0, squares = 0, largest = -1, smallest = std::numeric_limits<double>::infinity();
  long long springs = 0;
  const auto coordinate = [&](int particle, int axis) {
    return double(xyz[3 * std::size_t(particle) + std::size_t(axis)]);
  };
  for (const Offset& offset : offsetsOf(family)) {
    for (int row = 0; row + offset.rows < sheet.rows; ++row) {
      for (int column = std::max(0, -offset.columns); column < sheet.columns - std::max(0, offset.columns); ++column) {
        const int a = row * sheet.columns + column, b = a + offset.rows * sheet.columns + offset.columns;
        if (sheet.missing.has(a + offset.from, offset.bit)) continue;
        double square = 0;
        for (const int axis : {0, 1, 2}) square += std::pow(coordinate(b, axis) - coordinate(a, axis), 2);
        const double strain = std::sqrt(square) / rest - 1;
        sum += strain, squares += strain * strain;
        largest = std::max(largest, strain), smallest = std::min(smallest, strain);
        ++springs;
      }
    }
  }
  if (springs == 0) return {};
  const auto count = double(springs);
  return {.mean = sum / count, .rms = std::sqrt(squares / count), .largest = largest, .smallest = smallest};
}

}  // namespace tyg

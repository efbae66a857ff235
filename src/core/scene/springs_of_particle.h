// The six springs that each particle of a grid owns, as steps on the grid. Must not know: forces.
#pragma once

#include <array>

#include "tyg/sheet.h"

namespace tyg {

/// From (c + fromColumn, r) to (c + toColumn, r + toRow).
struct SpringOfParticle {
  Missing::Bit bit;
  Family family;
  int fromColumn, toColumn, toRow;
};

inline constexpr std::array<SpringOfParticle, 6> kSpringsOfParticle{{
    {Missing::Right, Family::Structural, 0, 1, 0},
    {Missing::Down, Family::Structural, 0, 0, 1},
    {Missing::DownRight, Family::Shear, 0, 1, 1},
    {Missing::DownLeft, Family::Shear, 1, 0, 1},
    {Missing::Right2, Family::Bend, 0, 2, 0},
    {Missing::Down2, Family::Bend, 0, 0, 2},
}};

/// Whether a sheet has this spring of particle (column, row).
constexpr bool isInside(const SpringOfParticle& spring, int column, int row, int columns, int rows) {
  const int farthest = spring.fromColumn > spring.toColumn ? spring.fromColumn : spring.toColumn;
  return column + farthest < columns && row + spring.toRow < rows;
}

}  // namespace tyg

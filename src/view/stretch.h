// How far the springs of a sheet are stretched, read off its positions.
// Must not know: forces, drawing.
#pragma once

#include <span>

#include "tyg/sheet.h"

namespace tyg {

/// Strains (length over rest length, less 1) of a family's springs; all 0 where it has none.
struct Stretch {
  double mean = 0;      ///< of all, shortened ones negative
  double rms = 0;       ///< of all
  double largest = 0;   ///< of the most stretched
  double smallest = 0;  ///< of the most shortened, > -1
};
/// `xyz` holds x, y, z of every particle, m.
Stretch stretchOf(const Sheet& sheet, std::span<const float> xyz, Family family);

}  // namespace tyg

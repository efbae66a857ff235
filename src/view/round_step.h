// Steps of axes and grids that people can count in.
// Must not know: what is counted.
#pragma once

#include <cmath>

namespace tyg {

/// 1, 2 or 5 times a power of ten, near to `wanted` (> 0).
inline double roundStep(double wanted) {
  const double power = std::pow(10.0, std::floor(std::log10(wanted))), ratio = wanted / power;
  return power * (ratio < 1.5 ? 1 : ratio < 3.5 ? 2 : ratio < 7.5 ? 5 : 10);
}

}  // namespace tyg

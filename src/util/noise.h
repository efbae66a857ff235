// Numbers that look random and are the same on every machine.
// Must not know: what they disturb.
#pragma once

#include <cstdint>

namespace tyg {

/// The next number from -1 to 1 of a linear congruential generator (the constants of Press et al., Numerical Recipes).
inline double noise(std::uint32_t& seed) {
  seed = 1664525U * seed + 1013904223U;
  return double(seed >> 8) / double(1U << 23) - 1;
}

}  // namespace tyg

// Finds the wave q = (qx, qy) in [0, pi]^2 at which a function of waves is smallest.
// Must not know: what the function means.
#pragma once

#include <functional>

#include "core/spectrum/lattice.h"

namespace tyg {

using WaveFunction = std::function<double(double qx, double qy)>;

struct LowestWave {
  double qx = 0, qy = 0;
  double value = 0;
};

/// The smallest value of a continuous function over all waves of the lattice; phases of a direction the lattice does
/// not have stay 0. A grid of 17 phases an axis finds the valleys, from the deepest of which a descent goes on to
/// strides of 1e-4. A wave whose value is NaN counts as infinite.
LowestWave lowestWave(const Lattice& lattice, const WaveFunction& values);

}  // namespace tyg

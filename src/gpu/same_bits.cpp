// The hash of a state tells whether all bits are the same; only where they are not are the particles looked at.
#include "gpu/same_bits.h"

#include <algorithm>
#include <cmath>

#include "tyg/simulation.h"

namespace tyg {

BitsCompared compareBits(const Scene& scene, const Method& method, const std::shared_ptr<Device>& device, int threads) {
  Simulation there(scene, method, {.threads = threads, .device = device});
  Simulation here(scene, method, {.threads = threads});
  there.tick(kStepsCompared), here.tick(kStepsCompared);
  BitsCompared compared{.same = there.hash() == here.hash()};
  if (compared.same) return compared;
  for (int particle = 0; particle < here.sheet().count(); ++particle) {
    const Vec3 a = here.position(particle), b = there.position(particle);
    const double distance = std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
    compared.strays = std::isnan(distance) ? distance : std::max(compared.strays, distance);
    if (std::isnan(distance)) break;
  }
  return compared;
}

}  // namespace tyg

// The hash of a state tells whether all of its bits are the same; only where they are not are the particles looked at.
#include "gpu/same_bits.h"

#include <algorithm>
#include <cmath>

#include "tyg/simulation.h"

namespace tyg {

namespace {

bool isFinite(const Simulation& simulation) {
  for (int particle = 0; particle < simulation.sheet().count(); ++particle) {
    const Vec3 at = simulation.position(particle);
    if (!std::isfinite(at.x + at.y + at.z)) return false;
  }
  return true;
}

/// What is not a number is no other number.
bool isSame(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

bool findsSameEnergies(const Simulation& there, const Simulation& here) {
  const Ledger a = there.glance().ledger, b = here.glance().ledger;
  return isSame(a.kinetic, b.kinetic) && isSame(a.stored.sum(), b.stored.sum()) && isSame(a.work.sum(), b.work.sum()) &&
         isSame(a.maxStretch, b.maxStretch);
}

BitsCompared compareAfter(int steps, const Scene& scene, const Method& method, const std::shared_ptr<Device>& device,
                          int threads) {
  // With the ledger the powers of all steps are compared as well.
  Simulation there(scene, method, {.threads = threads, .ledger = true, .device = device});
  Simulation here(scene, method, {.threads = threads, .ledger = true});
  there.tick(steps), here.tick(steps);
  // A run that has blown up here too says nothing: what is no number has many bits.
  if (steps > 1 && !isFinite(here)) return compareAfter(steps / 2, scene, method, device, threads);
  BitsCompared compared{.steps = steps};
  compared.same = there.hash() == here.hash();
  if (compared.same) {
    compared.same = findsSameEnergies(there, here);
    return compared;
  }
  for (int particle = 0; particle < here.sheet().count(); ++particle) {
    const Vec3 a = here.position(particle), b = there.position(particle);
    const double distance = std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
    compared.strays = std::isnan(distance) ? distance : std::max(compared.strays, distance);
    if (std::isnan(distance)) break;
  }
  return compared;
}

}  // namespace

BitsCompared compareBits(const Scene& scene, const Method& method, const std::shared_ptr<Device>& device, int threads) {
  return compareAfter(kStepsCompared, scene, method, device, threads);
}

}  // namespace tyg

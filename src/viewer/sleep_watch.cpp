// Looks at the kinetic energy first, which is at hand, and at single particles only where that is small enough.
#include "viewer/sleep_watch.h"

#include <algorithm>

namespace tyg {
namespace {

bool isStill(const Simulation& simulation, double kinetic) {
  const Sheet& sheet = simulation.sheet();
  constexpr double kSlow = SleepWatch::kStillSpeed * SleepWatch::kStillSpeed;
  if (!(kinetic < sheet.count() * sheet.particleMass * kSlow / 2)) return false;
  const auto isToCome = [&](const Push& push) { return push.at + push.duration > simulation.time(); };
  if (std::ranges::any_of(simulation.scene().pushes, isToCome)) return false;
  for (int particle = 0; particle < sheet.count(); ++particle) {
    const Vec3 v = simulation.velocity(particle);
    if (!(v.x * v.x + v.y * v.y + v.z * v.z < kSlow)) return false;
  }
  return true;
}

}  // namespace

void SleepWatch::follow(const Simulation& simulation, double kinetic) {
  if (!isStill(simulation, kinetic)) return wake();
  if (!stillSince_ || *stillSince_ > simulation.time()) stillSince_ = simulation.time();
}

}  // namespace tyg

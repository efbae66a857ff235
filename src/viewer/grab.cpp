// The velocity that takes the particle evenly to where the cursor wants it.
#include "viewer/grab.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace tyg {

void Grab::begin(const ToolScope& scope, int particle, glm::vec2 cursor, glm::vec2 aside) {
  const auto xyz = scope.run.shown().positions().subspan(3 * static_cast<std::size_t>(particle), 3);
  const glm::vec3 there(xyz[0], xyz[1], xyz[2]);
  particle_ = particle;
  wanted_ = there;
  velocity_ = {};
  holds_ = point_.begin(scope, there, cursor, aside);
}

void Grab::release(const ToolScope& scope) {
  if (!std::exchange(holds_, false)) return;
  if (std::ranges::binary_search(scope.run.simulation().held(), particle_)) scope.run.intervene().release(particle_);
}

void Grab::frame(const ToolScope& scope) {
  if (point_.slips(scope.run)) forget();
  if (!holds_ || !scope.view.visible()) return;
  wanted_ = point_.wanted(scope).value_or(wanted_);
}

Vec3 Grab::velocityFor(const Simulation& simulation, std::int64_t due) const {
  const Vec3 here = simulation.position(particle_);
  const glm::dvec3 way = glm::dvec3(wanted_) - glm::dvec3(here.x, here.y, here.z);
  const glm::dvec3 velocity = handVelocity(way, double(due) * simulation.dt(), simulation.sheet().size());
  return {velocity.x, velocity.y, velocity.z};
}

std::int64_t Grab::follow(Simulation& simulation, std::int64_t due) {
  if (const auto held = simulation.held(); !held.empty()) {
    // A past from which time went on may have ended amid a grab, and so may a run that froze: no hand is there now.
    for (const int particle : std::vector<int>(held.begin(), held.end())) {
      if (!holds_ || particle != particle_) simulation.release(particle);
    }
  }
  if (!holds_) return std::numeric_limits<std::int64_t>::max();
  const Vec3 velocity = velocityFor(simulation, due);
  if (simulation.held().empty() || velocity != velocity_) simulation.grab(particle_, velocity_ = velocity);
  return due;
}

}  // namespace tyg

// Where the cursor wants the particle, and the velocity that takes it there evenly.
#include "viewer/grab.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "view/picking.h"

namespace tyg {
namespace {

/// The way to the wanted place is spread over the ticks of so many frames: the cursor comes in jumps, and a particle
/// that is let go must not have the speed of one jump.
constexpr double kFrames = 2;
/// Sheet sizes per second that a hand moves at most. A quick flick of the mouse crosses the sheet in about a fifth of a
/// second. What is faster, such as a jump of the cursor while time passes slowly, would stretch springs beyond anything
/// that looks like cloth; the particle then comes later.
constexpr double kFastest = 5;
constexpr float kNotch = 1.05F;  // by which one notch of the wheel multiplies the distance from the eye
constexpr double kThere = 1e-7;  // sheet sizes: nearer is where it is wanted
constexpr float kNearest = 0.05F, kFarthest = 20;  // sheet sizes from the eye

glm::vec2 windowOf(const ToolScope& scope) { return {scope.view.pixels().width, scope.view.pixels().height}; }

}  // namespace

void Grab::begin(const ToolScope& scope, int particle, glm::vec2 cursor, glm::vec2 aside) {
  const Camera& camera = scope.view.camera();
  const auto xyz = scope.run.shown().positions().subspan(3 * static_cast<std::size_t>(particle), 3);
  const glm::vec3 there(xyz[0], xyz[1], xyz[2]);
  particle_ = particle;
  cursor_ = cursor;
  wanted_ = there;
  depth_ = glm::dot(there - camera.eye(), camera.forward());
  aside_ = aside;
  velocity_ = {};
  tick_ = scope.run.simulation().ticks();
  holds_ = depth_ > 0;
  if (holds_ && scope.run.state() == RunState::Running) scope.run.intervene();  // it wakes, or ends a replay
}

void Grab::pushAway(float notches) { depth_ *= std::pow(kNotch, std::clamp(notches, -20.0F, 20.0F)); }

void Grab::release(const ToolScope& scope) {
  if (!std::exchange(holds_, false)) return;
  if (std::ranges::binary_search(scope.run.simulation().held(), particle_)) scope.run.intervene().release(particle_);
}

void Grab::frame(const ToolScope& scope) {
  const RunControl& run = scope.run;
  if (run.state() == RunState::Frozen || run.seeking() || run.timeline().past) forget();
  if (run.simulation().ticks() < std::exchange(tick_, run.simulation().ticks())) forget();
  if (!holds_ || !scope.view.visible()) return;
  const Camera& camera = scope.view.camera();
  const auto size = static_cast<float>(run.simulation().sheet().size());
  depth_ = std::clamp(depth_, kNearest * size, std::max(kFarthest * size, camera.distance()));
  const Ray ray = sightLine(camera, cursor_ + aside_, windowOf(scope));
  const glm::vec3 there = ray.origin + depth_ / glm::dot(ray.direction, camera.forward()) * ray.direction;
  if (std::isfinite(there.x + there.y + there.z)) wanted_ = there;
}

Vec3 Grab::velocityFor(const Simulation& simulation, std::int64_t due) const {
  const Vec3 here = simulation.position(particle_);
  const glm::dvec3 way = glm::dvec3(wanted_) - glm::dvec3(here.x, here.y, here.z);
  const double size = simulation.sheet().size(), distance = glm::length(way);
  if (distance <= kThere * size) return {};
  const double seconds = kFrames * double(due) * simulation.dt();
  const glm::dvec3 velocity = way * std::min(1 / seconds, kFastest * size / distance);
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

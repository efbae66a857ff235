// The plane keeps its distance from the eye while the camera turns, within what a view of the cloth can hold.
#include "viewer/held_point.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "view/picking.h"
#include "viewer/tool.h"

namespace tyg {
namespace {

/// Sheet sizes per second that a hand moves at most. A quick flick of the mouse crosses the sheet in about a fifth of a
/// second. What is faster, such as a jump of the cursor while time passes slowly, would stretch springs beyond anything
/// that looks like cloth; what is held then comes later.
constexpr double kFastest = 5;
/// The way is spread over the ticks of so many frames: the cursor comes in jumps, and what is let go must not have the
/// speed of one jump.
constexpr double kFrames = 2;
constexpr double kThere = 1e-7;  // sheet sizes: nearer is where it is wanted
constexpr float kNotch = 1.05F;  // by which one notch of the wheel multiplies the distance from the eye
constexpr float kNearest = 0.05F, kFarthest = 20;  // sheet sizes from the eye

}  // namespace

glm::vec2 windowOf(const ToolScope& scope) { return {scope.view.pixels().width, scope.view.pixels().height}; }

bool HeldPoint::begin(const ToolScope& scope, const glm::vec3& point, glm::vec2 cursor, glm::vec2 aside) {
  const Camera& camera = scope.view.camera();
  cursor_ = cursor, aside_ = aside;
  depth_ = glm::dot(point - camera.eye(), camera.forward());
  tick_ = scope.run.simulation().ticks();
  if (depth_ > 0 && scope.run.state() == RunState::Running) scope.run.intervene();
  return depth_ > 0;
}

bool HeldPoint::slips(const RunControl& run) {
  const bool wentBack = run.simulation().ticks() < std::exchange(tick_, run.simulation().ticks());
  return wentBack || run.state() == RunState::Frozen || run.seeking() || run.timeline().past;
}

void HeldPoint::pushAway(float notches) { depth_ *= std::pow(kNotch, std::clamp(notches, -20.0F, 20.0F)); }

std::optional<glm::vec3> HeldPoint::wanted(const ToolScope& scope) {
  const Camera& camera = scope.view.camera();
  const auto size = static_cast<float>(scope.run.simulation().sheet().size());
  depth_ = std::clamp(depth_, kNearest * size, std::max(kFarthest * size, camera.distance()));
  const Ray ray = sightLine(camera, cursor_ + aside_, windowOf(scope));
  const glm::vec3 there = ray.origin + depth_ / glm::dot(ray.direction, camera.forward()) * ray.direction;
  if (!std::isfinite(there.x + there.y + there.z)) return std::nullopt;
  return there;
}

glm::dvec3 handVelocity(const glm::dvec3& way, double seconds, double size) {
  const double distance = glm::length(way);
  if (distance <= kThere * size) return glm::dvec3(0);
  return way * std::min(1 / (kFrames * seconds), kFastest * size / distance);
}

}  // namespace tyg

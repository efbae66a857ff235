// What time has passed decides how far a jump goes, whatever ticks were meant to pass. None is farther than half the
// layer of contact, so that the cloth feels a surface that moves.
#include "viewer/body_grab.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <utility>
#include <vector>

#include "core/forces/terms/contact.h"
#include "core/simulation/live_parameters.h"
#include "view/body_shapes.h"

namespace tyg {
namespace {

constexpr float kLiesOn = 2;  // spacings that a particle which lies on a body may be farther from the eye than the body

glm::dvec3 pointAt(const Vec3& v) { return {v.x, v.y, v.z}; }

Scene withBodyMoved(Scene scene, std::size_t body, const glm::dvec3& by) {
  const glm::dvec3 place = pointAt(scene.bodies[body].at) + by;
  scene.bodies[body].at = {place.x, place.y, place.z};
  return scene;
}

glm::dvec3 placeNow(const Simulation& simulation, std::size_t body) {
  return pointAt(placeOf(simulation.scene(), body, simulation.time()));
}

}  // namespace

std::optional<PickedBody> BodyGrab::bodyAt(const ToolScope& scope, glm::vec2 cursor, std::optional<int> particle) {
  const Simulation& simulation = scope.run.simulation();
  if (simulation.scene().bodies.empty()) return std::nullopt;
  std::vector<Body> bodies;
  placeBodies(simulation.scene(), scope.run.shown().time(), bodies);
  const Ray ray = sightLine(scope.view.camera(), cursor, windowOf(scope));
  const std::optional<PickedBody> picked = pickBody(ray, bodies);
  if (!picked || !particle) return picked;
  const auto xyz = scope.run.shown().positions().subspan(3 * static_cast<std::size_t>(*particle), 3);
  const float distance = glm::distance(ray.origin, glm::vec3(xyz[0], xyz[1], xyz[2]));
  const float behind = distance - picked->distance;
  return behind > kLiesOn * static_cast<float>(simulation.sheet().spacing) ? picked : std::nullopt;
}

bool BodyGrab::canMove(const Scene& scene, std::size_t body) {
  return !sameLiveParameters(scene, withBodyMoved(scene, body, glm::dvec3(1)));
}

void BodyGrab::begin(const ToolScope& scope, const PickedBody& picked, glm::vec2 cursor) {
  const glm::dvec3 place = placeNow(scope.run.simulation(), picked.body);
  const Ray ray = sightLine(scope.view.camera(), cursor, windowOf(scope));
  const glm::vec3 held = ray.origin + picked.distance * ray.direction;
  body_ = picked.body;
  wanted_ = place, aside_ = place - glm::dvec3(held);
  velocity_ = glm::dvec3(0);
  isNewFrame_ = false;
  movedAt_ = scope.run.simulation().ticks();
  holds_ = point_.begin(scope, held, cursor, glm::vec2(0));
}

void BodyGrab::frame(const ToolScope& scope) {
  if (point_.slips(scope.run)) release();
  if (!holds_ || !scope.view.visible()) return;
  if (const auto held = point_.wanted(scope)) wanted_ = glm::dvec3(*held) + aside_;
  isNewFrame_ = true;
  if (scope.run.state() != RunState::Running) jump(scope.run.intervene(), way(scope.run.simulation()));
}

glm::dvec3 BodyGrab::way(const Simulation& simulation) const { return wanted_ - placeNow(simulation, body_); }

void BodyGrab::jump(Simulation& simulation, const glm::dvec3& by) {
  if (by == glm::dvec3(0)) return;
  try {
    simulation.useLiveParameters(withBodyMoved(simulation.scene(), body_, by));
  } catch (const std::exception&) {
    release();  // so far away that no number is allowed
  }
}

std::int64_t BodyGrab::follow(Simulation& simulation, std::int64_t due) {
  constexpr auto kAny = std::numeric_limits<std::int64_t>::max();
  const double dt = simulation.dt();
  const std::int64_t passed = simulation.ticks() - std::exchange(movedAt_, simulation.ticks());
  if (!holds_) return kAny;
  jump(simulation, double(passed) * dt * velocity_);
  const double farthest = simulation.scene().contact.layer / 2;
  if (std::exchange(isNewFrame_, false)) {
    const Scene& scene = simulation.scene();
    const Vec3 itsOwn = motionOf(scene, scene.bodies[body_], simulation.time(), 0).velocity;
    velocity_ = handVelocity(way(simulation), double(due) * dt, simulation.sheet().size()) - pointAt(itsOwn);
    const double perTick = dt * glm::length(velocity_);
    if (perTick > farthest) velocity_ *= farthest / perTick;
  }
  const double perTick = dt * glm::length(velocity_);
  if (!(perTick > 0)) return kAny;
  return static_cast<std::int64_t>(std::clamp(farthest / perTick, 1.0, double(due)));
}

}  // namespace tyg

// Which particle or which body a cursor points at, and what of a cloth is seen.
// Must not know: OpenGL, windows, what is done with the particle.
#pragma once

#include <optional>
#include <span>

#include <glm/glm.hpp>

#include "tyg/scene.h"
#include "tyg/sheet.h"
#include "view/camera.h"

namespace tyg {

/// A half line from the eye into the scene, m.
struct Ray {
  glm::vec3 origin;
  glm::vec3 direction;  ///< unit vector
};
/// The line of sight through a cursor. `cursor` in pixels from the top left corner of a window of `window` pixels; both
/// in the same kind of pixels (a window's own coordinates will do).
Ray sightLine(const Camera& camera, glm::vec2 cursor, glm::vec2 window);

/// Where a point (m) in front of the eye is seen, in those pixels; not finite in the plane of the eye.
glm::vec2 placeInWindow(const Camera& camera, const glm::vec3& point, glm::vec2 window);

/// The middle of those particles that are seen in the window, m; of all where none is. Pieces that have fallen out of
/// sight do not count. `xyz`: positions, m.
glm::vec3 middleInView(const Camera& camera, glm::vec2 window, std::span<const float> xyz);

/// How far from the cloth a click still counts, in pixels.
inline constexpr float kPickRadius = 12;

/// The particle under the cursor, pinned ones included. Where the cursor is on the cloth it is the corner nearest to it
/// of the mesh cell that the eye sees first, of those that no cut has taken. Within `radius` pixels beside it (and on
/// chains and single particles) it is the nearer end of the structural spring that is nearest to the cursor, or a
/// particle that has none. Nothing: the click misses the cloth.
/// `xyz` holds 3 * sheet.count() numbers; particles that are not finite or behind the eye are never picked.
std::optional<int> pickParticle(const Camera& camera, glm::vec2 cursor, glm::vec2 window, const Sheet& sheet,
                                std::span<const float> xyz, float radius = kPickRadius);

/// A body that a line of sight meets.
struct PickedBody {
  std::size_t body;  ///< its place in the list
  float distance;    ///< m, from the eye to its surface
};
/// The first ball, capsule or box that a line of sight meets, from outside. Planes are never picked: a floor is
/// everywhere.
std::optional<PickedBody> pickBody(const Ray& ray, std::span<const Body> bodies);

}  // namespace tyg

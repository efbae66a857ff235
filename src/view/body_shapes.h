// Bodies as things to draw: where they are at a time, triangles around balls, capsules and boxes, how much of a plane
// is shown, and the points of them that a view of the cloth should hold.
// Must not know: OpenGL, how bodies push the cloth.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "tyg/scene.h"
#include "view/camera.h"
#include "view/solid_vertex.h"

namespace tyg {

/// Replaces `bodies` by those of the scene with Body::at where they are at this time, s. Allocates nothing where it is
/// called again for the same scene.
void placeBodies(const Scene& scene, double time, std::vector<Body>& bodies);

/// Triangles of a ball, a capsule or a box around the origin, m, three vertices each and counterclockwise as seen from
/// outside; none of a plane. Curved parts have `perQuarter` (> 0) pieces in each quarter of a turn.
std::vector<SolidVertex> bodySolid(const Body& body, int perQuarter);
/// From the axes of bodySolid() to the world's, without any change of size.
glm::mat4 bodyModel(const Body& body);
/// Whether the two have the same bodySolid().
bool sameSolid(const Body& a, const Body& b);

/// The smallest box around a body that is no plane, m.
Box boxOf(const Body& body);
/// Two unit vectors across a direction; the cross product of the first and the second is the direction.
std::array<glm::vec3, 2> acrossOf(const glm::vec3& direction);

/// The part of a plane that is shown: a disc, m.
struct PlanePatch {
  glm::vec3 middle;
  glm::vec3 across, along;  ///< unit vectors in the plane; cross(across, along) is its normal
  float radius;
};
/// Around a sheet that is now within `cloth`, and around the bodies near to it.
PlanePatch patchOf(const Body& plane, const Box& cloth, std::span<const Body> bodies);

/// The surroundings of a cloth within this box that a view of it may show, so that the cloth stays large in the view.
Box surroundingsOf(const Box& cloth);
/// Of all bodies, the points that belong into a view of a cloth within this box, m: none outside of its surroundings.
void addBodyPoints(std::span<const Body> bodies, const Box& cloth, std::vector<glm::vec3>& points);

/// Camera::nearest(), m, or less where a body is nearer to the eye than the cloth is.
float nearestWith(const Camera& camera, std::span<const Body> bodies);

}  // namespace tyg

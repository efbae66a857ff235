// The light of a scene's lamps, and where the shadow of a cloth and its bodies falls on the floor.
// Must not know: OpenGL, colours of things.
#pragma once

#include <array>
#include <optional>
#include <span>

#include <glm/glm.hpp>

#include "tyg/scene.h"
#include "view/box.h"

namespace tyg {

struct Light {
  glm::vec4
      from;  ///< the unit vector towards a lamp that is far away, and 0; or the place of one that is near, m, and 1
  glm::vec3 colour;  ///< red, green, blue, 0..1 each
};
struct Lights {
  std::array<Light, kMostLamps> lights{};
  int count = 0;  ///< 1 at least
};
/// Those of a scene; without a lamp the usual one, from above, from the left and from the front.
Lights lightsOf(std::span<const Lamp> lamps);

/// A plane that shadows fall on.
struct Floor {
  glm::vec3 at;      ///< m
  glm::vec3 normal;  ///< of length 1, towards the cloth
};
/// The first plane among the bodies; else the level ground at this height (m), where there is one.
std::optional<Floor> floorOf(std::span<const Body> bodies, std::optional<float> ground);

/// The part of a floor that a shadow covers, and how points get there (Blinn 1988).
struct FloorShadow {
  glm::mat4 projection;     ///< from points (m) to that part: x and y from -1 to 1, after division by w
  glm::vec3 middle;         ///< m
  glm::vec3 across, along;  ///< from there to two neighbouring edges, m
};
/// The shadow of what is within the box of the cloth and around the bodies, of this light. None where the light does
/// not come from above all of them, and where it falls too far away to be seen with the cloth.
std::optional<FloorShadow> shadowOn(const Floor& floor, const Light& light, const Box& cloth,
                                    std::span<const Body> bodies);

}  // namespace tyg

// The shadow is projected by one matrix, and a second one takes the part of the floor that it covers to a square.
#include "view/lamp_light.h"

#include <algorithm>
#include <cmath>

#include "view/body_shapes.h"

namespace tyg {
namespace {

const glm::vec3 kUsualLight(-0.42F, 0.80F, 0.43F);  // towards the lamp

constexpr float kFarthest = 4;  // cloth sizes from below the cloth to the end of its shadow

glm::vec3 vec(const Vec3& v) { return {float(v.x), float(v.y), float(v.z)}; }

/// Blinn (1988): takes every point to where its shadow is on the floor. w is positive where the light shines on it from
/// above.
glm::mat4 ontoFloor(const Floor& floor, const glm::vec4& light) {
  const glm::vec4 plane(floor.normal, -glm::dot(floor.normal, floor.at));
  return glm::dot(plane, light) * glm::mat4(1) - glm::outerProduct(light, plane);
}

/// A span of the floor that grows with what is seen on it.
struct Reach {
  glm::vec2 low{0}, high{0};
  bool empty = true;
  void take(const glm::vec2& point) {
    low = empty ? point : glm::min(low, point), high = empty ? point : glm::max(high, point);
    empty = false;
  }
};

}  // namespace

Lights lightsOf(std::span<const Lamp> lamps) {
  Lights all;
  for (const Lamp& lamp : lamps.first(std::min<std::size_t>(lamps.size(), kMostLamps))) {
    const double length = std::hypot(lamp.direction.x, lamp.direction.y, lamp.direction.z);
    const Vec3 towards{-lamp.direction.x / length, -lamp.direction.y / length, -lamp.direction.z / length};
    const glm::vec4 from = lamp.at ? glm::vec4(vec(*lamp.at), 1) : glm::vec4(vec(towards), 0);
    all.lights.at(std::size_t(all.count++)) = {from, vec(lamp.colour)};
  }
  if (all.count == 0)
    all.lights.at(std::size_t(all.count++)) = {glm::vec4(glm::normalize(kUsualLight), 0), glm::vec3(1)};
  return all;
}

std::optional<Floor> floorOf(std::span<const Body> bodies, std::optional<float> ground) {
  const auto plane = std::ranges::find(bodies, Shape::Plane, &Body::shape);
  if (plane != bodies.end()) return Floor{vec(plane->at), vec(plane->normal)};
  if (ground) return Floor{{0, *ground, 0}, {0, 1, 0}};
  return std::nullopt;
}

std::optional<FloorShadow> shadowOn(const Floor& floor, const Light& light, const Box& cloth,
                                    std::span<const Body> bodies) {
  const glm::mat4 shadow = ontoFloor(floor, light.from);
  const auto [across, along] = acrossOf(floor.normal);
  const glm::vec3 below = cloth.centre() - glm::dot(cloth.centre() - floor.at, floor.normal) * floor.normal;
  const auto onFloor = [&, across = across, along = along](const glm::vec3& point) {
    return glm::vec2(glm::dot(point - below, across), glm::dot(point - below, along));
  };
  Reach reach;
  const auto take = [&](const Box& box) {
    return std::ranges::all_of(box.corners(), [&](const glm::vec3& corner) {
      const glm::vec4 place = shadow * glm::vec4(corner, 1);
      if (!(place.w > 0)) return false;
      reach.take(onFloor(glm::vec3(place) / place.w));
      return true;
    });
  };
  if (!take(cloth)) return std::nullopt;
  for (const Body& body : bodies) {
    if (body.shape != Shape::Plane && !take(boxOf(body))) return std::nullopt;
  }
  const float farthest = kFarthest * cloth.size();
  const glm::vec2 low = glm::max(reach.low, glm::vec2(-farthest)), high = glm::min(reach.high, glm::vec2(farthest));
  if (!glm::all(glm::lessThan(low, high))) return std::nullopt;
  const glm::vec2 middle = 0.5F * (low + high), half = 0.5F * (high - low);
  FloorShadow found{.projection = {},
                    .middle = below + middle.x * across + middle.y * along,
                    .across = half.x * across,
                    .along = half.y * along};
  const glm::vec4 toX(across / half.x, -glm::dot(found.middle, across) / half.x);
  const glm::vec4 toY(along / half.y, -glm::dot(found.middle, along) / half.y);
  found.projection = glm::transpose(glm::mat4(toX, toY, glm::vec4(0), glm::vec4(0, 0, 0, 1))) * shadow;
  return found;
}

}  // namespace tyg

// A ball, a capsule and a box are one shape: a sphere that is cut into its eight octants, which are moved apart to the
// corners of a core. What opens between them is the flat and the straight part of the surface.
#include "view/body_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/forces/terms/contact.h"

namespace tyg {
namespace {

glm::vec3 vec(const Vec3& v) { return {float(v.x), float(v.y), float(v.z)}; }

/// Half of the extents of the core in the axes of the solid; a capsule lies along y.
glm::vec3 coreOf(const Body& body) {
  if (body.shape == Shape::Capsule) return {0, glm::length(vec(body.axis)) / 2, 0};
  if (body.shape == Shape::Box) return vec(body.half) - float(body.radius);
  return glm::vec3(0);
}

/// A direction from the middle of a sphere, and the octant to which it belongs.
struct Direction {
  glm::vec3 normal, octant;
};

/// Rings around y, from the pole above to the one below. The equator and every quarter of it come twice, once for each
/// of the octants beside it.
class Rings {
 public:
  explicit Rings(int perQuarter) : perQuarter_(perQuarter) {}
  [[nodiscard]] int rings() const { return 2 * (perQuarter_ + 1); }
  [[nodiscard]] int places() const { return 4 * (perQuarter_ + 1); }  ///< of a ring
  [[nodiscard]] Direction at(int ring, int place) const {
    const int half = ring / (perQuarter_ + 1), quarter = place / (perQuarter_ + 1) % 4;
    const int down = ring - half, around = place - place / (perQuarter_ + 1);
    const bool isRight = quarter == 0 || quarter == 3, isFront = quarter < 2;
    return {{sine(down) * cosine(around), cosine(down), sine(down) * sine(around)},
            {isRight ? 1 : -1, half == 0 ? 1 : -1, isFront ? 1 : -1}};
  }

 private:
  /// Of so many pieces of a turn; exactly 0 where it is 0, so that what should meet does.
  [[nodiscard]] float sine(int pieces) const {
    return pieces % (2 * perQuarter_) == 0 ? 0 : std::sin(1.57079633F * float(pieces) / float(perQuarter_));
  }
  [[nodiscard]] float cosine(int pieces) const { return sine(pieces + perQuarter_); }

  int perQuarter_;
};

void addTriangle(const SolidVertex& a, const SolidVertex& b, const SolidVertex& c, std::vector<SolidVertex>& to) {
  if (a.position == b.position || b.position == c.position || c.position == a.position) return;
  to.insert(to.end(), {a, b, c});
}

bool meet(const Box& a, const Box& b) {
  return glm::all(glm::lessThanEqual(a.low, b.high)) && glm::all(glm::lessThanEqual(b.low, a.high));
}

glm::vec3 onPlane(const Body& plane, const glm::vec3& point) {
  const glm::vec3 normal = vec(plane.normal);
  return point - glm::dot(point - vec(plane.at), normal) * normal;
}

}  // namespace

std::array<glm::vec3, 2> acrossOf(const glm::vec3& direction) {
  const glm::vec3 least = std::abs(direction.y) < 0.999F ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, -1);
  const glm::vec3 first = glm::normalize(glm::cross(least, direction));
  return {first, glm::cross(direction, first)};
}

Box boxOf(const Body& body) {
  const glm::vec3 at = vec(body.at), end = body.shape == Shape::Capsule ? at + vec(body.axis) : at;
  const glm::vec3 reach = body.shape == Shape::Box ? vec(body.half) : glm::vec3(float(body.radius));
  return {glm::min(at, end) - reach, glm::max(at, end) + reach};
}

void placeBodies(const Scene& scene, double time, std::vector<Body>& bodies) {
  bodies = scene.bodies;
  for (std::size_t k = 0; k < bodies.size(); ++k) bodies[k].at = placeOf(scene, k, time);
}

std::vector<SolidVertex> bodySolid(const Body& body, int perQuarter) {
  std::vector<SolidVertex> solid;
  if (body.shape == Shape::Plane) return solid;
  const glm::vec3 core = coreOf(body);
  const auto radius = float(body.radius);
  const Rings all(perQuarter);
  const auto vertex = [&](int ring, int place) {
    const Direction direction = all.at(ring, place);
    return SolidVertex{radius * direction.normal + core * direction.octant, direction.normal};
  };
  const SolidVertex top{{0, core.y + radius, 0}, {0, 1, 0}}, bottom{{0, -core.y - radius, 0}, {0, -1, 0}};
  const int last = all.rings() - 1;
  for (int place = 0; place < all.places(); ++place) {
    const int next = (place + 1) % all.places();
    addTriangle(top, vertex(0, next), vertex(0, place), solid);
    for (int ring = 0; ring < last; ++ring) {
      const SolidVertex a = vertex(ring, place), b = vertex(ring, next), c = vertex(ring + 1, place),
                        d = vertex(ring + 1, next);
      addTriangle(a, b, d, solid), addTriangle(a, d, c, solid);
    }
    addTriangle(bottom, vertex(last, place), vertex(last, next), solid);
  }
  return solid;
}

glm::mat4 bodyModel(const Body& body) {
  const glm::vec3 at = vec(body.at);
  if (body.shape != Shape::Capsule) return {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, glm::vec4(at, 1)};
  const glm::vec3 axis = vec(body.axis), up = glm::normalize(axis);
  const auto [first, second] = acrossOf(up);
  return {glm::vec4(second, 0), glm::vec4(up, 0), glm::vec4(first, 0), glm::vec4(at + 0.5F * axis, 1)};
}

bool sameSolid(const Body& a, const Body& b) {
  return a.shape == b.shape && a.axis == b.axis && a.half == b.half && a.radius == b.radius;
}

PlanePatch patchOf(const Body& plane, const Box& cloth, std::span<const Body> bodies) {
  constexpr float kUsual = 3, kBeyond = 0.7F, kFar = 4;  // cloth sizes
  const glm::vec3 middle = onPlane(plane, cloth.centre());
  const auto [across, along] = acrossOf(vec(plane.normal));
  PlanePatch patch{.middle = middle, .across = across, .along = along, .radius = kUsual * cloth.size()};
  for (const Body& body : bodies) {
    if (body.shape == Shape::Plane) continue;
    const Box box = boxOf(body);
    const float away = glm::distance(middle, onPlane(plane, box.centre())) + box.size() / 2;
    patch.radius = std::max(patch.radius, std::min(away, kFar * cloth.size()) + kBeyond * cloth.size());
  }
  return patch;
}

Box surroundingsOf(const Box& cloth) {
  constexpr float kAround = 0.75F;  // cloth sizes
  const glm::vec3 around(kAround * cloth.size());
  return {cloth.low - around, cloth.high + around};
}

void addBodyPoints(std::span<const Body> bodies, const Box& cloth, std::vector<glm::vec3>& points) {
  constexpr int kPerQuarter = 3;
  constexpr float kUnder = 0.5F;  // of the cloth's extents: the middle of what is under it shows where a plane is
  const Box around = surroundingsOf(cloth);
  for (const Body& body : bodies) {
    if (body.shape == Shape::Plane) {
      for (const glm::vec3& corner : cloth.corners()) {
        points.push_back(glm::clamp(onPlane(body, glm::mix(cloth.centre(), corner, kUnder)), around.low, around.high));
      }
    } else if (meet(boxOf(body), around)) {
      const glm::mat4 model = bodyModel(body);
      for (const SolidVertex& vertex : bodySolid(body, kPerQuarter)) {
        points.push_back(glm::clamp(glm::vec3(model * glm::vec4(vertex.position, 1)), around.low, around.high));
      }
    }
  }
}

float nearestWith(const Camera& camera, std::span<const Body> bodies) {
  float nearest = camera.nearest();
  for (const Body& body : bodies) {
    if (body.shape == Shape::Plane) {
      const glm::vec3 there = onPlane(body, camera.eye());
      nearest = std::min(nearest, camera.nearest({there, there}));
    } else {
      nearest = std::min(nearest, camera.nearest(boxOf(body)));
    }
  }
  return nearest;
}

}  // namespace tyg

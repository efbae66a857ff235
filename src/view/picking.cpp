// One pass over the sheet in window coordinates, which keeps one row back to make the cells between two rows.
#include "view/picking.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace tyg {
namespace {

/// A particle as the cursor sees it: offset in pixels, depth in m along the line of sight (not above 0: cannot be
/// seen).
struct Seen {
  glm::vec2 offset{0};
  float depth = 0;
  [[nodiscard]] bool visible() const { return depth > 0; }
};

/// Offsets are measured about the cursor, so "under the cursor" means "about the origin".
class Sight {
 public:
  Sight(const Camera& camera, glm::vec2 cursor, glm::vec2 window)
      : view_(camera.view()),
        focal_(window.y / (2 * std::tan(camera.fieldOfView() / 2))),
        shift_(window / 2.0F - cursor),
        nearest_(camera.nearest()) {}

  [[nodiscard]] Seen see(const float* xyz) const {
    const glm::vec4 p = view_ * glm::vec4(xyz[0], xyz[1], xyz[2], 1);
    const glm::vec2 offset = shift_ + focal_ / -p.z * glm::vec2(p.x, -p.y);
    const bool valid = -p.z > nearest_ && std::isfinite(offset.x) && std::isfinite(offset.y) && std::isfinite(p.z);
    return valid ? Seen{offset, -p.z} : Seen{};
  }

 private:
  glm::mat4 view_;
  float focal_;
  glm::vec2 shift_;
  float nearest_;
};

float cross(glm::vec2 a, glm::vec2 b) { return a.x * b.y - a.y * b.x; }

/// Depth at which the line of sight meets a triangle; infinite where it does not.
float depthAt(const Seen& a, const Seen& b, const Seen& c) {
  constexpr float kMiss = std::numeric_limits<float>::infinity();
  const float wa = cross(b.offset, c.offset), wb = cross(c.offset, a.offset), wc = cross(a.offset, b.offset);
  const bool inside = (wa >= 0 && wb >= 0 && wc >= 0) || (wa <= 0 && wb <= 0 && wc <= 0);
  const float area = wa + wb + wc;
  if (!a.visible() || !b.visible() || !c.visible() || !inside || area == 0) {
    return kMiss;
  }
  // 1/depth, not depth, is linear in the window.
  return area / (wa / a.depth + wb / b.depth + wc / c.depth);
}

class Picker {
 public:
  explicit Picker(float radius) : reach2_(radius * radius) {}

  void offerParticle(const Seen& seen, int particle) {
    const float distance2 = glm::dot(seen.offset, seen.offset);
    if (seen.visible() && (distance2 < reach2_ || (distance2 == reach2_ && seen.depth < besideDepth_))) {
      reach2_ = distance2, besideDepth_ = seen.depth, beside_ = particle;
    }
  }

  /// A spring between two particles.
  void offerSpring(const Seen& a, int particleA, const Seen& b, int particleB) {
    if (!a.visible() || !b.visible()) return;
    const glm::vec2 way = b.offset - a.offset;
    const float length2 = glm::dot(way, way);
    const float along = length2 > 0 ? std::clamp(-glm::dot(a.offset, way) / length2, 0.0F, 1.0F) : 0;
    const float depth = glm::mix(a.depth, b.depth, along);
    offerParticle({a.offset + along * way, depth}, along < 0.5F ? particleA : particleB);
  }

  /// The cell between four particles, in order around it.
  void offerCell(const std::array<Seen, 4>& corners, const std::array<int, 4>& particles) {
    const float depth =
        std::min(depthAt(corners[0], corners[1], corners[2]), depthAt(corners[0], corners[2], corners[3]));
    if (depth >= cellDepth_) {
      return;
    }
    cellDepth_ = depth;
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const float distance2 = glm::dot(corners[i].offset, corners[i].offset);
      if (corners[i].visible() && distance2 < least) {
        least = distance2, onCloth_ = particles[i];
      }
    }
  }

  [[nodiscard]] std::optional<int> picked() const { return onCloth_ ? onCloth_ : beside_; }

 private:
  float reach2_, besideDepth_ = std::numeric_limits<float>::infinity();
  float cellDepth_ = std::numeric_limits<float>::infinity();
  std::optional<int> beside_, onCloth_;
};

glm::vec3 vec(const Vec3& v) { return {float(v.x), float(v.y), float(v.z)}; }

/// From a place to the surface of a ball, a capsule or a box; not above 0 inside, m.
float distanceTo(const Body& body, const glm::vec3& place) {
  glm::vec3 from = place - vec(body.at);
  if (body.shape == Shape::Capsule) {
    const glm::vec3 axis = vec(body.axis);
    from -= std::clamp(glm::dot(from, axis) / glm::dot(axis, axis), 0.0F, 1.0F) * axis;
  } else if (body.shape == Shape::Box) {
    const glm::vec3 core = vec(body.half) - float(body.radius);
    from -= glm::clamp(from, -core, core);
  }
  return glm::length(from) - float(body.radius);
}

/// How far along a ray the surface of a body begins, m. No surface is nearer than the distance to it, so the ray may go
/// on by that much (Hart, sphere tracing, 1996).
std::optional<float> distanceAlong(const Ray& ray, const Body& body) {
  constexpr int kMostSteps = 200;
  constexpr float kNear = 1e-4F;  // of the way so far
  float along = 0;
  for (int step = 0; step < kMostSteps; ++step) {
    const float distance = distanceTo(body, ray.origin + along * ray.direction);
    if (!std::isfinite(distance)) break;
    if (distance <= kNear * along) return along;
    along += distance;
  }
  return std::nullopt;
}

}  // namespace

Ray sightLine(const Camera& camera, glm::vec2 cursor, glm::vec2 window) {
  const float slope = std::tan(camera.fieldOfView() / 2);
  const glm::vec2 aside = window.y > 0 ? (cursor - window / 2.0F) * (2 * slope / window.y) : glm::vec2(0);
  return {camera.eye(), glm::normalize(camera.forward() + aside.x * camera.right() - aside.y * camera.up())};
}

glm::vec2 placeInWindow(const Camera& camera, const glm::vec3& point, glm::vec2 window) {
  const glm::vec3 away = point - camera.eye();
  const float focal = window.y / (2 * std::tan(camera.fieldOfView() / 2)) / glm::dot(away, camera.forward());
  return window / 2.0F + focal * glm::vec2(glm::dot(away, camera.right()), -glm::dot(away, camera.up()));
}

glm::vec3 middleInView(const Camera& camera, glm::vec2 window, std::span<const float> xyz) {
  std::vector<float> seen;
  for (std::size_t k = 0; k + 2 < xyz.size(); k += 3) {
    const glm::vec3 point(xyz[k], xyz[k + 1], xyz[k + 2]);
    if (glm::dot(point - camera.eye(), camera.forward()) <= 0) continue;
    const glm::vec2 place = placeInWindow(camera, point, window);
    const bool isInside = place.x >= 0 && place.y >= 0 && place.x <= window.x && place.y <= window.y;
    if (isInside) seen.insert(seen.end(), {point.x, point.y, point.z});
  }
  return boxAround(seen.empty() ? xyz : std::span<const float>(seen)).centre();
}

std::optional<int> pickParticle(const Camera& camera, glm::vec2 cursor, glm::vec2 window, const Sheet& sheet,
                                std::span<const float> xyz, float radius) {
  if (!(window.x > 0 && window.y > 0) || xyz.size() < 3 * static_cast<std::size_t>(sheet.count())) {
    return std::nullopt;
  }
  const Sight sight(camera, cursor, window);
  Picker picker(radius);
  const auto columns = static_cast<std::size_t>(sheet.columns);
  std::vector<Seen> above(columns), row(columns);
  for (int r = 0; r < sheet.rows; ++r) {
    for (int c = 0; c < sheet.columns; ++c) {
      const int particle = r * sheet.columns + c;
      const auto i = static_cast<std::size_t>(c);
      row[i] = sight.see(&xyz[3 * static_cast<std::size_t>(particle)]);
      picker.offerParticle(row[i], particle);
      if (c > 0 && !sheet.missing.has(particle - 1, Missing::Right)) {
        picker.offerSpring(row[i - 1], particle - 1, row[i], particle);
      }
      if (r > 0 && !sheet.missing.has(particle - sheet.columns, Missing::Down)) {
        picker.offerSpring(above[i], particle - sheet.columns, row[i], particle);
      }
      if (r > 0 && c > 0) {
        const int over = particle - sheet.columns;
        if (sheet.missing.has(over - 1, Missing::Cell)) continue;  // between two parts of the cloth there is none
        picker.offerCell({above[i - 1], above[i], row[i], row[i - 1]}, {over - 1, over, particle, particle - 1});
      }
    }
    std::swap(above, row);
  }
  return picker.picked();
}

std::optional<PickedBody> pickBody(const Ray& ray, std::span<const Body> bodies) {
  std::optional<PickedBody> picked;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (bodies[k].shape == Shape::Plane) continue;
    const std::optional<float> distance = distanceAlong(ray, bodies[k]);
    if (distance && *distance > 0 && (!picked || *distance < picked->distance)) picked = PickedBody{k, *distance};
  }
  return picked;
}

}  // namespace tyg

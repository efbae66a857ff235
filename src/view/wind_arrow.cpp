// Rings of triangles around x: the foot, the shaft, the underside of the head, the head.
#include "view/wind_arrow.h"

#include <array>
#include <cmath>

namespace tyg {
namespace {

constexpr int kSides = 24;
constexpr float kThin = 0.045F, kWide = 0.13F, kNeck = 0.12F;  // radii, and where the head begins; lengths of the arrow

glm::vec3 around(float x, float radius, float angle) { return {x, radius * std::cos(angle), radius * std::sin(angle)}; }

/// The band from one ring to the next; a radius of 0 makes it a disc or a cone.
void addBand(glm::vec2 from, glm::vec2 to, std::vector<SolidVertex>& vertices) {
  const glm::vec2 along = glm::normalize(to - from);
  for (int side = 0; side < kSides; ++side) {
    const std::array<float, 2> angles{6.2831853F * float(side) / kSides, 6.2831853F * float(side + 1) / kSides};
    const auto vertex = [&](glm::vec2 ring, float angle) {
      return SolidVertex{around(ring.x, ring.y, angle), around(-along.y, along.x, angle)};
    };
    const SolidVertex a = vertex(from, angles[0]), b = vertex(from, angles[1]), c = vertex(to, angles[0]),
                      d = vertex(to, angles[1]);
    vertices.insert(vertices.end(), {a, b, d, a, d, c});
  }
}

}  // namespace

std::vector<SolidVertex> arrowSolid() {
  constexpr std::array<glm::vec2, 5> kProfile{
      glm::vec2{-0.5F, 0}, {-0.5F, kThin}, {kNeck, kThin}, {kNeck, kWide}, {0.5F, 0}};
  std::vector<SolidVertex> vertices;
  for (std::size_t k = 1; k < kProfile.size(); ++k) addBand(kProfile.at(k - 1), kProfile.at(k), vertices);
  return vertices;
}

glm::mat4 windArrowModel(const ShownWind& wind) {
  const glm::vec3 velocity(wind.velocity.x, wind.velocity.y, wind.velocity.z);
  const float speed = glm::length(velocity);
  constexpr float kShortest = 0.37F, kUsualSpeed = 10;  // of the longest, m/s
  const float length = wind.longest * (kShortest + (1 - kShortest) * speed / (speed + kUsualSpeed));
  const glm::vec3 along = speed > 0 && std::isfinite(speed) ? velocity / speed : glm::vec3(1, 0, 0);
  const glm::vec3 leastAlong = std::abs(along.y) < 0.9F ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 side = glm::normalize(glm::cross(along, leastAlong)), other = glm::cross(along, side);
  return {glm::vec4(length * along, 0), glm::vec4(length * side, 0), glm::vec4(length * other, 0),
          glm::vec4(0, 0, 0, 1)};
}

glm::mat4 windArrowProjection(const ShownWind& wind, float aspect) {
  return {glm::vec4(2 / aspect, 0, 0, 0), glm::vec4(0, 2, 0, 0), glm::vec4(0, 0, -1, 0),
          glm::vec4(2 * wind.at.x - 1, 1 - 2 * wind.at.y, 0, 1)};
}

glm::vec2 windArrowPlace() { return {0.12F, 0.17F}; }

}  // namespace tyg

// Lines straight from the springs of a sheet; the arrow is a shaft and a cone of four edges and a rim.
#include "view/sheet_lines.h"

#include <algorithm>
#include <cmath>

namespace tyg {

std::vector<std::uint32_t> linesOf(const Sheet& sheet, Family family) {
  const std::vector<SpringEnds> springs = springsOf(sheet, family);
  std::vector<std::uint32_t> lines;
  lines.reserve(2 * springs.size());
  for (const SpringEnds& spring : springs) {
    lines.push_back(static_cast<std::uint32_t>(spring.first));
    lines.push_back(static_cast<std::uint32_t>(spring.second));
  }
  return lines;
}

float groundHeight(const Sheet& sheet) {
  // A cloth hanging by its top reaches one side down; swinging and stretching take it a quarter farther.
  const double side = (sheet.rows - 1) * sheet.spacing;
  return static_cast<float>(-1.3 * std::max(side, 0.4 * sheet.size()));
}

std::vector<std::uint32_t> arrowLines() {
  std::vector<std::uint32_t> lines{0, 1};
  for (std::uint32_t i = 0; i < kArrowRim; ++i) {
    lines.insert(lines.end(), {2 + i, 2 + (i + 1) % kArrowRim});
    if (i % (kArrowRim / 4) == 0) {
      lines.insert(lines.end(), {2 + i, 1});
    }
  }
  return lines;
}

std::array<glm::vec3, kArrowPoints> arrowPoints(const glm::vec3& foot, const glm::vec3& force, float length) {
  const float strength = glm::length(force);
  const glm::vec3 along = strength > 0 && std::isfinite(strength) ? force / strength : glm::vec3(0, 1, 0);
  const glm::vec3 leastAlong = std::abs(along.y) < 0.9F ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 side = glm::normalize(glm::cross(along, leastAlong)), other = glm::cross(along, side);
  std::array<glm::vec3, kArrowPoints> points;
  points[0] = foot;
  points[1] = foot + length * along;
  for (int i = 0; i < kArrowRim; ++i) {
    const float angle = 6.2831853F * static_cast<float>(i) / kArrowRim;
    points[static_cast<std::size_t>(2 + i)] =
        foot + 0.75F * length * along + 0.075F * length * (std::cos(angle) * side + std::sin(angle) * other);
  }
  return points;
}

float arrowLength(const Sheet& sheet, double newtons) {
  // Pushes range over decades, so the length follows a curve that saturates: a newton gives about a quarter of the
  // sheet.
  const double share = 0.1 + 0.4 * (1 - std::exp(-std::max(newtons, 0.0) / 2));
  return static_cast<float>(share * sheet.size());
}

}  // namespace tyg

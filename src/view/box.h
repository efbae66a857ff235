// The axis-aligned box around a cloth: what cameras frame, arrows point to and shading measures depth by.
// Must not know: cameras, OpenGL.
#pragma once

#include <array>
#include <span>

#include <glm/glm.hpp>

namespace tyg {

/// From `low` to `high`, m. A default one is a metre wide about the origin, so that nothing divides by zero.
struct Box {
  glm::vec3 low{-0.5F}, high{0.5F};

  [[nodiscard]] glm::vec3 centre() const { return 0.5F * (low + high); }
  /// Length of the diagonal, m, always above zero (a single particle counts as a millimetre).
  [[nodiscard]] float size() const;
  [[nodiscard]] std::array<glm::vec3, 8> corners() const;
  /// The smallest box that holds both.
  [[nodiscard]] Box with(const Box& other) const;
};

/// The box around positions stored x, y, z (m). Positions that are not finite are left out; none left: the default box.
Box boxAround(std::span<const float> xyz);

}  // namespace tyg

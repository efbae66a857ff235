// A sheet as things to draw: pairs of particles that lines join, pins, an arrow for a push, the height of the ground.
// Must not know: OpenGL, cameras.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "tyg/sheet.h"

namespace tyg {

/// Particle indices of a family's springs, two per line.
std::vector<std::uint32_t> linesOf(const Sheet& sheet, Family family);

/// Where to draw the ground so that the hanging cloth does not touch it, m (y).
float groundHeight(const Sheet& sheet);

/// An arrow as lines: a shaft, and a cone as head. Seen from behind the cone is a circle with a cross, the sign for a
/// vector that points away from the reader; a flat head would vanish there, and pushes go along the line of sight.
inline constexpr int kArrowRim = 16;                ///< points around the cone
inline constexpr int kArrowPoints = 2 + kArrowRim;  ///< foot, tip, rim
/// Indices into an arrow's points, two per line.
std::vector<std::uint32_t> arrowLines();
/// The points of an arrow of `length` m (> 0) from `foot` along `force` (N; zero: straight up).
std::array<glm::vec3, kArrowPoints> arrowPoints(const glm::vec3& foot, const glm::vec3& force, float length);

/// The length that shows a force in a sheet, m: it grows with the force and stays between a tenth and half the sheet.
float arrowLength(const Sheet& sheet, double newtons);

}  // namespace tyg

// Scales of colours for numbers on the cloth: the same for the lines and for the bars that explain them.
// Must not know: OpenGL, what the numbers are.
#pragma once

#include <array>

#include <glm/glm.hpp>

namespace tyg {

enum class Background { Dark, Light };

/// A colour, 0..1, from its hexadecimal notation, 0xrrggbb.
constexpr glm::vec3 rgb(unsigned hex) {
  return {float(hex >> 16U & 255U) / 255, float(hex >> 8U & 255U) / 255, float(hex & 255U) / 255};
}

/// Growing: from little to much, ever farther from the background. Balanced: two hues that meet in grey at the middle.
/// Both run in lightness too, so that the colour-blind and grey prints tell more from less.
enum class Ramp { Growing, Balanced };

using RampColours = std::array<glm::vec3, 5>;  ///< at equal distances; mixed between
const RampColours& coloursOf(Ramp ramp, Background background);

}  // namespace tyg

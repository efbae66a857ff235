// How passes draw discs: round, of a size in pixels, at points of a Positions object.
// Must not know: what the discs are.
#pragma once

#include "gfx/passes/frame.h"
#include "gfx/passes/programs.h"

namespace tyg {

/// Lengths in pixels, times the scale of the frame's options.
struct DiscStyle {
  Shading shading;
  float diameter = 1;
  float least = 1;    ///< a disc that would be smaller is drawn fainter instead
  float outline = 0;  ///< in the background's colour
};
/// A large disc that sets off a single particle: a pin, the foot of a push.
inline DiscStyle markerStyle(const glm::vec3& colour) {
  return {.shading = {.colour = colour}, .diameter = 12, .least = 6, .outline = 1.5F};
}

class DiscDrawing {
 public:
  explicit DiscDrawing(Programs& programs) : program_(programs.get("discs")) {}
  /// Prepares for glDraw...(GL_POINTS, ...) with the vertices of a Positions object bound.
  void use(const Frame& frame, const DiscStyle& style) const {
    useShaded(program_, frame, style.shading);
    program_.set("diameter", style.diameter * frame.options.scale);
    program_.set("least", style.least * frame.options.scale);
    program_.set("outline", style.outline * frame.options.scale);
  }

 private:
  const GlProgram& program_;
};

}  // namespace tyg

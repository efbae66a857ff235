// How passes draw lines: anti-aliased, of a width in pixels, between points of a Positions object.
// Must not know: what the lines are.
#pragma once

#include <cstdint>
#include <span>

#include "gfx/gl_objects.h"
#include "gfx/passes/frame.h"
#include "gfx/passes/positions.h"
#include "gfx/passes/programs.h"
#include "tyg/sheet.h"

namespace tyg {

/// Which points are joined, on the GPU.
class LineEnds {
 public:
  /// Numbers of points, two per line.
  explicit LineEnds(std::span<const std::uint32_t> pairs);
  [[nodiscard]] GLsizei count() const { return count_; }
  [[nodiscard]] GLuint texture() const { return texture_.name(); }

 private:
  GlBuffer buffer_;
  GlTexture texture_;
  GLsizei count_;
};

/// Colours of lines by a number: by each line's strain, or by the numbers of the points at its ends.
struct LineColours {
  const Colouring* by = nullptr;  ///< null: one colour
  GLuint values = 0;              ///< a texture with a number for each point, where the colours are by particle
  float restLength = 1;           ///< m, of every line
};
struct LineStyle {
  Shading shading;
  float width = 1;               ///< pixels, times the scale of the frame's options
  float sideways = 0;            ///< as wide, from where the line lies to where it is drawn
  float opacity = 1;             ///< 0..1
  bool onSurface = false;        ///< fades out where lines are too dense to be told apart, and leaves the surface
  const Sheet* sheet = nullptr;  ///< of whose mesh they are; needed where the shading has a spacing
  LineColours colours{};
};

class LineDrawing {
 public:
  explicit LineDrawing(Programs& programs) : program_(programs.get("lines")) {}
  void draw(const Frame& frame, const Positions& positions, const LineEnds& ends, const LineStyle& style) const;

 private:
  void setColours(const Frame& frame, const LineColours& colours) const;

  const GlProgram& program_;
  GlVertexArray nothing_;  // the shader looks everything up; OpenGL still wants a vertex array
};

}  // namespace tyg

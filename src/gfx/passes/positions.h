// Points on the GPU, renewed once a frame, for every shader: as a texture, in which the line shader looks points up by
// number, and as vertices, one disc each. Must not know: what the points are.
#pragma once

#include <span>

#include "gfx/gl_objects.h"

namespace tyg {

class Positions {
 public:
  /// As many points as it can look up with this driver.
  static int mostPoints();
  /// Space for that many, up to mostPoints().
  explicit Positions(int points);

  /// x, y, z of each point, m.
  void upload(std::span<const float> xyz) const;
  /// The same from a buffer of this context.
  void copy(GLuint from) const;
  [[nodiscard]] GLuint buffer() const { return buffer_.name(); }
  [[nodiscard]] GLuint texture() const { return texture_.name(); }
  /// A vertex array with the points as its first attribute.
  [[nodiscard]] GLuint vertices() const { return vertices_.name(); }

 private:
  GLsizeiptr bytes_;
  GlBuffer buffer_;
  GlTexture texture_;
  GlVertexArray vertices_;
};

}  // namespace tyg

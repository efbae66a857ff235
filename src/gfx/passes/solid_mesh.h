// How passes draw solid things: triangles that are uploaded once.
// Must not know: what is solid, how it is shaded.
#pragma once

#include <cstddef>
#include <span>

#include "gfx/gl_objects.h"
#include "view/solid_vertex.h"

namespace tyg {

class SolidMesh {
 public:
  /// Three vertices for each triangle.
  explicit SolidMesh(std::span<const SolidVertex> triangles) : count_(static_cast<GLsizei>(triangles.size())) {
    glBindVertexArray(vertices_.name());
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangles.size_bytes()), triangles.data(), GL_STATIC_DRAW);
    usePart(0, offsetof(SolidVertex, position));
    usePart(1, offsetof(SolidVertex, normal));
    glBindVertexArray(0);
  }

  /// With the program in use, whose first two attributes are a vertex's position and its normal.
  void draw() const {
    glBindVertexArray(vertices_.name());
    glDrawArrays(GL_TRIANGLES, 0, count_);
  }

 private:
  static void usePart(GLuint index, std::size_t offset) {
    glEnableVertexAttribArray(index);
    const void* const place = reinterpret_cast<const void*>(offset);  // NOLINT(performance-no-int-to-ptr): OpenGL's way
    glVertexAttribPointer(index, 3, GL_FLOAT, GL_FALSE, sizeof(SolidVertex), place);
  }

  GlVertexArray vertices_;
  GlBuffer buffer_;
  GLsizei count_;
};

}  // namespace tyg

// One buffer behind a texture of single numbers and a vertex array.
#include "gfx/passes/positions.h"

namespace tyg {
namespace {
constexpr GLuint kPositionAttribute = 0;  // of discs.vert
}

int Positions::mostPoints() {
  GLint numbers = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &numbers);
  return numbers / 3;
}

Positions::Positions(int points) : bytes_(GLsizeiptr{3} * points * GLsizeiptr{sizeof(float)}) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  glBufferData(GL_ARRAY_BUFFER, bytes_, nullptr, GL_STREAM_DRAW);
  glBindTexture(GL_TEXTURE_BUFFER, texture_.name());
  glTexBuffer(GL_TEXTURE_BUFFER, GL_R32F, buffer_.name());
  glBindVertexArray(vertices_.name());
  glEnableVertexAttribArray(kPositionAttribute);
  glVertexAttribPointer(kPositionAttribute, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  glBindVertexArray(0);
}

void Positions::upload(std::span<const float> xyz) const {
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  // A new store for each frame: the driver need not wait for the last frame to be done with the old one.
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(xyz.size_bytes()), xyz.data(), GL_STREAM_DRAW);
}

void Positions::copy(GLuint from) const {
  glBindBuffer(GL_COPY_READ_BUFFER, from);
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_ARRAY_BUFFER, 0, 0, bytes_);
}

}  // namespace tyg

// The arrow is uploaded once. It is drawn in the nearest part of the depths, in front of everything, and still hides
// its own far side.
#include "gfx/passes/wind_pass.h"

#include <vector>

#include "view/wind_arrow.h"

namespace tyg {
namespace {

constexpr double kNearest = 0.01;  // of all depths

void usePart(GLuint index, std::size_t offset) {
  glEnableVertexAttribArray(index);
  const void* const place = reinterpret_cast<const void*>(offset);  // NOLINT(performance-no-int-to-ptr): OpenGL's way
  glVertexAttribPointer(index, 3, GL_FLOAT, GL_FALSE, sizeof(SolidVertex), place);
}

}  // namespace

WindPass::WindPass(const Canvas& /*canvas*/) {
  const std::vector<SolidVertex> arrow = arrowSolid();
  count_ = static_cast<GLsizei>(arrow.size());
  glBindVertexArray(vertices_.name());
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(arrow.size() * sizeof(SolidVertex)), arrow.data(),
               GL_STATIC_DRAW);
  usePart(0, offsetof(SolidVertex, position));
  usePart(1, offsetof(SolidVertex, normal));
  glBindVertexArray(0);
}

void WindPass::draw(const Frame& frame) {
  if (!frame.options.wind || frame.options.over) return;
  program_.use();
  const ShownWind& wind = *frame.options.wind;
  program_.set("model", windArrowModel(wind));
  program_.set("view", glm::mat4(glm::mat3(frame.view)));  // turned as the cloth is, but not moved
  program_.set("projection", windArrowProjection(wind, frame.pixels.x / frame.pixels.y));
  program_.set("colour", frame.palette.wind);
  glBindVertexArray(vertices_.name());
  glDepthRange(0, kNearest);
  glDrawArrays(GL_TRIANGLES, 0, count_);
  glDepthRange(0, 1);
}

}  // namespace tyg

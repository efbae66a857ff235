// Each line is six vertices, two triangles in window space, which lines.vert makes from the two ends. A mesh is drawn
// twice, solid middles first: lines.frag says why.
#include "gfx/passes/line_drawing.h"

#include <algorithm>

namespace tyg {
namespace {

constexpr float kHairlineSpacing = 3.5F;                    // pixels between lines that are thinner than a pixel
enum Part { Middles = 0, Edges = 1, Both = 2 };             // of lines.frag
enum TextureUnit { PointsUnit = 0, EndsUnit, ValuesUnit };  // in which lines.vert finds its three textures

void bindTexture(TextureUnit unit, GLuint texture) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_BUFFER, texture);
}

}  // namespace

LineEnds::LineEnds(std::span<const std::uint32_t> pairs) : count_(static_cast<GLsizei>(pairs.size() / 2)) {
  glBindBuffer(GL_TEXTURE_BUFFER, buffer_.name());
  glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(pairs.size_bytes()), pairs.data(), GL_STATIC_DRAW);
  glBindTexture(GL_TEXTURE_BUFFER, texture_.name());
  glTexBuffer(GL_TEXTURE_BUFFER, GL_RG32UI, buffer_.name());
}

void LineDrawing::setColours(const Frame& frame, const LineColours& colours) const {
  program_.set("colouring", colours.by == nullptr ? 0 : static_cast<int>(colours.by->by));
  if (colours.by == nullptr) return;
  program_.set("values", int{ValuesUnit});
  program_.set("restLength", colours.restLength);
  program_.set("range", glm::vec2(colours.by->low, colours.by->high));
  program_.set("ramp", std::span<const glm::vec3>(coloursOf(colours.by->ramp, frame.options.background)));
  if (colours.by->by == Colouring::By::Particle) bindTexture(ValuesUnit, colours.values);
}

void LineDrawing::draw(const Frame& frame, const Positions& positions, const LineEnds& ends,
                       const LineStyle& style) const {
  useShaded(program_, frame, style.shading);
  setColours(frame, style.colours);
  program_.set("opacityOfAll", style.opacity);
  program_.set("onSurface", int{style.onSurface});
  program_.set("positions", int{PointsUnit});
  program_.set("lines", int{EndsUnit});
  program_.set("pixels", frame.pixels);
  program_.set("nearest", frame.camera.nearest());
  program_.set("width", style.width * frame.options.scale);
  program_.set("sideways", style.sideways * frame.options.scale);
  if (style.sheet != nullptr) {
    program_.set("columns", style.sheet->columns);
    program_.set("particles", style.sheet->count());
    program_.set("sideBySide", static_cast<float>(std::min(style.sheet->columns, style.sheet->rows)));
  }
  glBindVertexArray(nothing_.name());
  bindTexture(EndsUnit, ends.texture());
  bindTexture(PointsUnit, positions.texture());
  // Lines thinner than a pixel have no solid middles to draw first.
  const float spacing = style.shading.spacing;
  const bool hairlines = spacing * frame.focal / frame.camera.distance() < kHairlineSpacing && spacing > 0;
  const auto drawPart = [&](Part part) {
    program_.set("part", int{part});
    glDepthMask(part == Middles ? GL_TRUE : GL_FALSE);
    glDrawArrays(GL_TRIANGLES, 0, 6 * ends.count());
  };
  if (hairlines) {
    drawPart(Both);
  } else {
    drawPart(Middles), drawPart(Edges);
  }
  glDepthMask(GL_TRUE);
}

}  // namespace tyg

// Drawn without a depth test, in front of everything: the cloth must not hide what is done to it.
#include "gfx/passes/push_pass.h"

namespace tyg {
namespace {
constexpr float kWidth = 2.6F;  // pixels
}

void PushPass::draw(const Frame& frame) {
  if (frame.push == nullptr) return;
  const auto at = 3 * static_cast<std::size_t>(frame.push->particle);
  const std::span<const float> xyz = frame.positions.xyz();
  const glm::vec3 foot(xyz[at], xyz[at + 1], xyz[at + 2]);
  const glm::vec3 force(frame.push->force.x, frame.push->force.y, frame.push->force.z);
  const auto points = arrowPoints(foot, force, arrowLength(canvas_.sheet, glm::length(force)));
  points_.upload({&points[0].x, 3 * points.size()});

  glDisable(GL_DEPTH_TEST);
  canvas_.lines.draw(frame, points_, ends_, {.shading = {.colour = frame.palette.push}, .width = kWidth});
  glBindVertexArray(points_.vertices());
  canvas_.discs.use(frame, markerStyle(frame.palette.push));
  glDrawArrays(GL_POINTS, 0, 1);  // the arrow's first point is its foot
  glEnable(GL_DEPTH_TEST);
}

}  // namespace tyg

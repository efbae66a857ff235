// A plane hides what is inside it only where the eye is outside: from inside it is a faint grid through which the cloth
// is seen.
#include "gfx/passes/plane_pass.h"

#include <algorithm>

#include "gfx/passes/sink.h"
#include "view/body_shapes.h"
#include "view/round_step.h"

namespace tyg {
namespace {

constexpr float kFaint = 0.3F;  // from inside

glm::vec3 vec(const Vec3& v) { return {float(v.x), float(v.y), float(v.z)}; }

/// The box in which the sheet starts, m.
Box startBox(const Sheet& sheet) {
  const glm::vec3 first = vec(sheet.startPosition(0)), last = vec(sheet.startPosition(sheet.count() - 1));
  return {glm::min(first, last), glm::max(first, last)};
}

}  // namespace

void PlanePass::draw(const Frame& frame) {
  const auto isPlane = [](const Body& body) { return body.shape == Shape::Plane; };
  if (frame.options.over || std::ranges::none_of(frame.options.bodies, isPlane)) return;
  const GlProgram& program = canvas_.programs.get("planes");
  program.use();
  program.set("view", frame.view);
  program.set("projection", frame.projection);
  program.set("cell", static_cast<float>(roundStep(canvas_.sheet.size() / 4)));
  program.set("colour", frame.palette.floor);
  program.set("grid", frame.palette.floorGrid);
  glBindVertexArray(nothing_.name());
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(kSlantedSink, 0);
  for (const Body& body : frame.options.bodies) {
    if (isPlane(body)) drawPlane(frame, program, body);
  }
  glDisable(GL_POLYGON_OFFSET_FILL);
}

void PlanePass::drawPlane(const Frame& frame, const GlProgram& program, const Body& plane) const {
  const PlanePatch patch = patchOf(plane, startBox(canvas_.sheet).with(frame.camera.watched()), frame.options.bodies);
  const glm::vec3 normal = vec(plane.normal), at = vec(plane.at);
  const bool outside = glm::dot(frame.camera.eye() - at, normal) > 0;
  program.set("middle", patch.middle - kSink * static_cast<float>(canvas_.sheet.spacing) * normal);
  program.set("across", patch.across);
  program.set("along", patch.along);
  program.set("radius", patch.radius);
  program.set("origin", glm::vec2(glm::dot(patch.middle - at, patch.across), glm::dot(patch.middle - at, patch.along)));
  program.set("fill", outside ? 1.0F : 0.0F);
  program.set("opacity", outside ? 1.0F : kFaint);
  glDepthMask(outside ? GL_TRUE : GL_FALSE);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glDepthMask(GL_TRUE);
}

}  // namespace tyg

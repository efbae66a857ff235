// Where a body is goes into a matrix.
#include "gfx/passes/body_pass.h"

#include "gfx/passes/sink.h"
#include "view/body_shapes.h"

namespace tyg {
namespace {

struct SoftEdge {
  float swell, opacity;  // pixels; 0..1
};
constexpr SoftEdge kSoftEdge[]{{0.4F, 0.6F}, {0.8F, 0.35F}};

}  // namespace

void BodyPass::drawSolids(const GlProgram& program, std::span<const Body> bodies, float swell, float opacity) const {
  program.set("swell", swell);
  program.set("opacity", opacity);
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (bodies[k].shape == Shape::Plane) continue;
    program.set("model", bodyModel(bodies[k]));
    canvas_.bodies.draw(k);
  }
}

void BodyPass::draw(const Frame& frame) {
  const std::span<const Body> bodies = frame.options.bodies;
  if (bodies.empty() || frame.options.over) return;
  const GlProgram& program = canvas_.programs.get("bodies");
  program.use();
  program.set("view", frame.view);
  program.set("projection", frame.projection);
  program.set("eye", frame.camera.eye());
  program.set("focal", frame.focal);
  program.set("sink", kSink * static_cast<float>(canvas_.sheet.spacing));
  program.set("colour", frame.palette.body);
  setLights(program, frame.lights);
  glEnable(GL_CULL_FACE), glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(kSlantedSink, 0);
  drawSolids(program, bodies, 0, 1);
  // Their far sides, a little larger, are seen around the outline alone: an edge of which less and less is covered.
  glCullFace(GL_FRONT), glDepthMask(GL_FALSE);
  for (const auto& [swell, opacity] : kSoftEdge) drawSolids(program, bodies, swell, opacity);
  glCullFace(GL_BACK), glDepthMask(GL_TRUE);
  glDisable(GL_CULL_FACE), glDisable(GL_POLYGON_OFFSET_FILL);
}

}  // namespace tyg

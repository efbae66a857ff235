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

void BodyPass::drawSolids(std::span<const Body> bodies, float swell, float opacity) const {
  program_->set("swell", swell);
  program_->set("opacity", opacity);
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (bodies[k].shape == Shape::Plane) continue;
    program_->set("model", bodyModel(bodies[k]));
    canvas_.bodies.draw(k);
  }
}

void BodyPass::draw(const Frame& frame) {
  const std::span<const Body> bodies = frame.options.bodies;
  if (bodies.empty() || frame.options.over) return;
  if (!program_) program_.emplace("bodies");
  program_->use();
  program_->set("view", frame.view);
  program_->set("projection", frame.projection);
  program_->set("eye", frame.camera.eye());
  program_->set("focal", frame.focal);
  program_->set("sink", kSink * static_cast<float>(canvas_.sheet.spacing));
  program_->set("colour", frame.palette.body);
  setLights(*program_, frame.lights);
  glEnable(GL_CULL_FACE), glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(kSlantedSink, 0);
  drawSolids(bodies, 0, 1);
  // Their far sides, a little larger, are seen around the outline alone: an edge of which less and less is covered.
  glCullFace(GL_FRONT), glDepthMask(GL_FALSE);
  for (const auto& [swell, opacity] : kSoftEdge) drawSolids(bodies, swell, opacity);
  glCullFace(GL_BACK), glDepthMask(GL_TRUE);
  glDisable(GL_CULL_FACE), glDisable(GL_POLYGON_OFFSET_FILL);
}

}  // namespace tyg

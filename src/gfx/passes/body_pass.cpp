// Where a body is goes into a matrix.
#include "gfx/passes/body_pass.h"

#include "gfx/passes/sink.h"
#include "view/body_shapes.h"

namespace tyg {
void BodyPass::draw(const Frame& frame) {
  const std::span<const Body> bodies = frame.options.bodies;
  if (bodies.empty() || frame.options.over) return;
  if (!program_) program_.emplace("bodies");
  program_->use();
  program_->set("view", frame.view);
  program_->set("projection", frame.projection);
  program_->set("eye", frame.camera.eye());
  program_->set("sink", kSink * static_cast<float>(canvas_.sheet.spacing));
  program_->set("colour", frame.palette.body);
  setLights(*program_, frame.lights);
  glEnable(GL_CULL_FACE), glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(kSlantedSink, 0);
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (bodies[k].shape == Shape::Plane) continue;
    program_->set("model", bodyModel(bodies[k]));
    canvas_.bodies.draw(k);
  }
  glDisable(GL_CULL_FACE), glDisable(GL_POLYGON_OFFSET_FILL);
}

}  // namespace tyg

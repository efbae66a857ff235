// The arrow is drawn in the nearest part of the depths, in front of everything, and still hides its own far side.
#include "gfx/passes/wind_pass.h"

namespace tyg {
namespace {
constexpr double kNearest = 0.01;  // of all depths
}

void WindPass::draw(const Frame& frame) {
  if (!frame.options.wind || frame.options.over) return;
  const GlProgram& program = programs_.get("solid");
  program.use();
  const ShownWind& wind = *frame.options.wind;
  program.set("model", windArrowModel(wind));
  program.set("view", glm::mat4(glm::mat3(frame.view)));  // turned as the cloth is, but not moved
  program.set("projection", windArrowProjection(wind, frame.pixels.x / frame.pixels.y));
  program.set("colour", frame.palette.wind);
  glDepthRange(0, kNearest);
  arrow_.draw();
  glDepthRange(0, 1);
}

}  // namespace tyg

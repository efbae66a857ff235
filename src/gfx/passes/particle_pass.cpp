// Both kinds of disc are vertices of the same positions; pins are chosen from them by number.
#include "gfx/passes/particle_pass.h"

namespace tyg {

ParticlePass::ParticlePass(const Canvas& canvas) : canvas_(canvas) { changeSheet(); }

void ParticlePass::changeSheet() {
  const std::vector<int>& pins = canvas_.sheet.pins;
  glBindBuffer(GL_ARRAY_BUFFER, pins_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(pins.size() * sizeof(int)), pins.data(), GL_STATIC_DRAW);
}

void ParticlePass::draw(const Frame& frame) {
  const Sheet& sheet = canvas_.sheet;
  glBindVertexArray(canvas_.positions.vertices());
  const bool alone = sheet.count() == 1 && frame.options.structural;  // without a line by which it would be seen
  if (frame.options.particles || alone) {
    const Shading shading{frame.palette.particle, meshFade(frame.options), static_cast<float>(sheet.spacing)};
    canvas_.discs.use(frame, {.shading = shading, .diameter = 5, .least = 1.5F});
    glDrawArrays(GL_POINTS, 0, sheet.count());
  }
  if (frame.options.pins && !sheet.pins.empty()) {
    canvas_.discs.use(frame, markerStyle(frame.palette.pin));
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, pins_.name());
    glDrawElements(GL_POINTS, static_cast<GLsizei>(sheet.pins.size()), GL_UNSIGNED_INT, nullptr);
  }
}

}  // namespace tyg

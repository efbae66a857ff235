// Sky, and a ground with a grid, for bearings: behind everything else.
// Must not know: where the particles are now (the ground lies where the sheet hung at the start).
#pragma once

#include "gfx/passes/pass.h"

namespace tyg {

class SurroundingsPass final : public Pass {
 public:
  explicit SurroundingsPass(const Canvas& canvas) : sheet_(canvas.sheet) {}
  void draw(const Frame& frame) override;

 private:
  const Sheet& sheet_;
  GlProgram program_{"surroundings"};
  GlVertexArray nothing_;  // the shader makes its one triangle itself
};

}  // namespace tyg

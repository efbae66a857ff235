// Planes that the cloth touches: a part of each around the cloth, with a grid, which fades out.
// Must not know: how they push the cloth, how they move.
#pragma once

#include "gfx/passes/pass.h"

namespace tyg {

class PlanePass final : public Pass {
 public:
  explicit PlanePass(const Canvas& canvas) : canvas_(canvas) {}
  void draw(const Frame& frame) override;

 private:
  void drawPlane(const Frame& frame, const GlProgram& program, const Body& plane) const;

  const Canvas& canvas_;
  GlVertexArray nothing_;  // the shader makes its square itself
};

}  // namespace tyg

// A wind: a small solid arrow along it, in a corner of the picture.
// Must not know: what the wind does to the cloth, where it comes from.
#pragma once

#include "gfx/passes/pass.h"
#include "gfx/passes/solid_mesh.h"
#include "view/wind_arrow.h"

namespace tyg {

class WindPass final : public Pass {
 public:
  explicit WindPass(const Canvas& canvas) : programs_(canvas.programs) {}
  void draw(const Frame& frame) override;

 private:
  Programs& programs_;
  SolidMesh arrow_{arrowSolid()};
};

}  // namespace tyg

// Balls, capsules and boxes that the cloth touches, in the light of the lamps; lines behind them are hidden.
// Must not know: how they push the cloth, how they move.
#pragma once

#include "gfx/passes/pass.h"

namespace tyg {

class BodyPass final : public Pass {
 public:
  explicit BodyPass(const Canvas& canvas) : canvas_(canvas) {}
  void draw(const Frame& frame) override;

 private:
  void drawSolids(const GlProgram& program, std::span<const Body> bodies, float swell, float opacity) const;

  const Canvas& canvas_;
};

}  // namespace tyg

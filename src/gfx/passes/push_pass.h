// A push: an arrow along its force, and a disc on the particle that it acts on.
// Must not know: what a push does to the cloth.
#pragma once

#include "gfx/passes/pass.h"
#include "view/sheet_lines.h"

namespace tyg {

class PushPass final : public Pass {
 public:
  explicit PushPass(const Canvas& canvas) : canvas_(canvas) {}
  void draw(const Frame& frame) override;

 private:
  const Canvas& canvas_;
  Positions points_{kArrowPoints};
  LineEnds ends_{arrowLines()};
};

}  // namespace tyg

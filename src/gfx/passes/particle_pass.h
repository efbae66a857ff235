// The particles as small discs and the pins as large ones.
// Must not know: what pins do.
#pragma once

#include "gfx/passes/pass.h"

namespace tyg {

class ParticlePass final : public Pass {
 public:
  explicit ParticlePass(const Canvas& canvas);
  void draw(const Frame& frame) override;
  void changeSheet() override;

 private:
  const Canvas& canvas_;
  GlBuffer pins_;  // which particles are pinned
};

}  // namespace tyg

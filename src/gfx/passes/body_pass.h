// Balls, capsules and boxes that the cloth touches, shaded; lines behind them are hidden.
// Must not know: how they push the cloth, how they move.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "gfx/passes/pass.h"
#include "gfx/passes/solid_mesh.h"

namespace tyg {

class BodyPass final : public Pass {
 public:
  explicit BodyPass(const Canvas& canvas) : canvas_(canvas) {}
  void draw(const Frame& frame) override;

 private:
  /// The mesh of a body, made again where the body has another shape than before.
  struct Solid {
    Body body;
    std::unique_ptr<const SolidMesh> mesh;
  };
  void renewSolids(std::span<const Body> bodies);
  void drawSolids(std::span<const Body> bodies, float swell, float opacity) const;

  const Canvas& canvas_;
  std::optional<GlProgram> program_;  // made when a body is first shown
  std::vector<Solid> solids_;
};

}  // namespace tyg

// Sky, and a ground with a grid, for bearings: behind everything else.
// Must not know: where the particles are now (the ground lies where the sheet hung at the start).
#pragma once

#include <optional>

#include "gfx/passes/kept_picture.h"
#include "gfx/passes/pass.h"

namespace tyg {

class SurroundingsPass final : public Pass {
 public:
  explicit SurroundingsPass(const Canvas& canvas)
      : sheet_(canvas.sheet), program_(canvas.programs.get("surroundings")) {}
  void draw(const Frame& frame) override;

 private:
  /// All that the picture depends on.
  struct Look {
    glm::vec3 eye, forward, rightward, upward, sky, ground, grid;
    float height, cell, extent;
    glm::vec2 middle, pixels;
    bool operator==(const Look&) const = default;
  };
  [[nodiscard]] Look lookOf(const Frame& frame) const;
  void paint(const Look& look) const;

  const Sheet& sheet_;
  const GlProgram& program_;
  GlVertexArray nothing_;  // the shader makes its one triangle itself
  KeptPicture picture_;
  std::optional<Look> painted_, kept_;
};

}  // namespace tyg

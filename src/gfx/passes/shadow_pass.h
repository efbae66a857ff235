// The shadow of the cloth and of bodies on the floor, where the cloth is shown as a surface.
// Must not know: how the floor is drawn.
#pragma once

#include <optional>

#include "gfx/passes/pass.h"
#include "view/lamp_light.h"

namespace tyg {

class ShadowPass final : public Pass {
 public:
  explicit ShadowPass(const Canvas& canvas) : canvas_(canvas) {}
  void prepare(const Frame& frame) override;
  void draw(const Frame& frame) override;

 private:
  /// Made when a shadow is first shown.
  struct Objects {
    Objects();
    GlFramebuffer framebuffer;
    GlTexture mask;
    GlVertexArray nothing;  // the shader makes its square itself
  };
  void drawMask(const Frame& frame, const Floor& floor);

  const Canvas& canvas_;
  std::optional<Objects> objects_;
  std::optional<FloorShadow> shadow_;  ///< of the present frame
};

}  // namespace tyg

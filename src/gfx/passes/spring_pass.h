// The springs as lines, one colour for each family or coloured by a number.
// Must not know: forces; what the numbers mean.
#pragma once

#include <array>
#include <optional>

#include "gfx/passes/pass.h"

namespace tyg {

class SpringPass final : public Pass {
 public:
  explicit SpringPass(const Canvas& canvas) : canvas_(canvas), missing_(canvas.sheet.missing) {}
  void draw(const Frame& frame) override;
  void changeSheet() override;

 private:
  void drawFamily(const Frame& frame, Family family, LineStyle style);
  [[nodiscard]] bool uploadValues(const Colouring& colouring) const;

  const Canvas& canvas_;
  Missing missing_;                                  // of the sheet that the families are of
  std::array<std::optional<LineEnds>, 3> families_;  // made when first shown: those of a large sheet take much memory
  GlBuffer values_;
  GlTexture valueTexture_;
};

}  // namespace tyg

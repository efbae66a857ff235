// The cloth as a surface: lit from both sides, in one colour, woven, with a picture on it, or coloured by a number.
// Must not know: how its triangles come about, what the numbers mean.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gfx/passes/pass.h"

namespace tyg {

class SurfacePass final : public Pass {
 public:
  explicit SurfacePass(const Canvas& canvas) : canvas_(canvas) {}
  void draw(const Frame& frame) override;

 private:
  enum class Pattern { None, Plain, Checker, Image, Numbers };
  /// Made when a surface is first shown.
  struct Objects {
    GlBuffer values;
    GlTexture valueTexture, image;
  };
  void drawSoftEdges(const Frame& frame, const GlProgram& program) const;
  [[nodiscard]] bool uploadValues(const Frame& frame);
  [[nodiscard]] Pattern patternOf(const Look& look);
  [[nodiscard]] glm::vec2 perCell(Pattern pattern) const;
  [[nodiscard]] bool loadImage(const std::string& path);

  const Canvas& canvas_;
  std::optional<Objects> objects_;
  std::vector<float> strains_;  ///< of the particles, where these are the numbers
  std::string imagePath_;       ///< of what is in the image texture, or could not be read
  bool hasImage_ = false;
};

}  // namespace tyg

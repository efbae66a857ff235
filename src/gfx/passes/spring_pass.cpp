// Bend springs lie along structural ones, so they are drawn beside them, and the structural mesh is drawn last.
#include "gfx/passes/spring_pass.h"

#include "view/sheet_lines.h"

namespace tyg {
namespace {
constexpr float kColouredFade = 0.2F;   // less than the mesh's: colours tell numbers
constexpr float kBesideStructural = 3;  // pixels from a structural line to the bend line along it
constexpr float kThinner = 0.7F;        // than structural lines, which stay the loudest
constexpr float kOnCloth = 0.55F;       // opacity of lines on a surface, which shows what they would
}  // namespace

void SpringPass::draw(const Frame& frame) {
  const DrawOptions& options = frame.options;
  const bool onCloth = canvas_.showsSurface(options);
  if (onCloth && options.show == Show::Surface) return;
  const bool coloured = !onCloth && options.colouring.by != Colouring::By::Family && uploadValues(options.colouring);
  LineStyle style{.shading = {.colour = {},
                              .fade = onCloth    ? 0
                                      : coloured ? kColouredFade
                                                 : meshFade(options),
                              .spacing = static_cast<float>(canvas_.sheet.spacing)},
                  .width = kThinner * options.lineWidth,
                  .opacity = onCloth ? kOnCloth * options.opacity : options.opacity,
                  .onSurface = onCloth,
                  .sheet = &canvas_.sheet,
                  .colours = {.by = coloured ? &options.colouring : nullptr, .values = valueTexture_.name()}};
  if (options.bend) {
    style.shading.colour = frame.palette.bend, style.sideways = kBesideStructural;
    drawFamily(frame, Family::Bend, style);
  }
  style.sideways = 0;
  if (options.shear) {
    style.shading.colour = frame.palette.shear;
    drawFamily(frame, Family::Shear, style);
  }
  if (options.structural) {
    style.shading.colour = options.mesh.value_or(onCloth ? frame.palette.onCloth : frame.palette.structural);
    style.width = options.lineWidth;
    drawFamily(frame, Family::Structural, style);
  }
}

void SpringPass::changeSheet() {
  if (missing_ == canvas_.sheet.missing) return;
  missing_ = canvas_.sheet.missing;
  for (auto& family : families_) family.reset();
}

void SpringPass::drawFamily(const Frame& frame, Family family, LineStyle style) {
  std::optional<LineEnds>& ends = families_.at(static_cast<std::size_t>(family));
  if (!ends) ends.emplace(linesOf(canvas_.sheet, family));
  style.colours.restLength = static_cast<float>(restLength(canvas_.sheet, family));
  canvas_.lines.draw(frame, canvas_.positions, *ends, style);
}

/// False where there is not a number for every particle.
bool SpringPass::uploadValues(const Colouring& colouring) const {
  if (colouring.by != Colouring::By::Particle) return true;
  if (colouring.values.size() != static_cast<std::size_t>(canvas_.sheet.count())) return false;
  glBindBuffer(GL_TEXTURE_BUFFER, values_.name());
  glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(colouring.values.size_bytes()), colouring.values.data(),
               GL_STREAM_DRAW);
  glBindTexture(GL_TEXTURE_BUFFER, valueTexture_.name());
  glTexBuffer(GL_TEXTURE_BUFFER, GL_R32F, values_.name());
  return true;
}

}  // namespace tyg

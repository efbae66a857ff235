// A ghost is drawn into the picture of the cloth, as lines alone, with the same renderer.
#include "ui/cloth_painter.h"

namespace tyg {

ClothPainter::ClothPainter(const Viewer& viewer)
    : renderer_(std::make_unique<SheetRenderer>(viewer.run().simulation().sheet())),
      sheet_(viewer.scenes().sheetsSoFar()) {}

void ClothPainter::draw(const Viewer& viewer, Panels& panels, Extent window) {
  if (sheet_ != viewer.scenes().sheetsSoFar()) *this = ClothPainter(viewer);
  ClothPicture picture{.options = viewer.view().drawOptions()};
  panels.paint(picture);
  const glm::ivec2 pixels{window.width, window.height};
  const Camera& camera = viewer.view().camera();
  const std::span<const float> positions = viewer.run().shown().positions();
  renderer_->draw(positions, camera, pixels, picture.options, viewer.tools().drawing().arrow);
  if (picture.ghost.size() != positions.size()) return;
  const bool dark = picture.options.background == Background::Dark;
  renderer_->draw(picture.ghost, camera, pixels,
                  {.pins = false,
                   .background = picture.options.background,
                   .mesh = dark ? rgb(0xf4f6f8) : rgb(0x20242a),
                   .over = true,
                   .opacity = picture.ghostOpacity});
}

}  // namespace tyg

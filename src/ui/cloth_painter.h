// The picture of the cloth in the window: the viewer's cloth and what the open panels show on it.
// Must not know: windows, text.
#pragma once

#include <memory>

#include "gfx/passes/sheet_renderer.h"
#include "ui/panels/panels.h"
#include "viewer/viewer.h"

namespace tyg {

class ClothPainter {
 public:
  /// A context must be current as long as this lives. Throws as SheetRenderer does.
  explicit ClothPainter(const Viewer& viewer);
  /// Into the bound framebuffer. Makes a new renderer where the viewer has another sheet than before.
  void draw(const Viewer& viewer, Panels& panels, Extent window);

 private:
  std::unique_ptr<SheetRenderer> renderer_;
  int sheet_;  ///< of SceneControl::sheetsSoFar(), the one that the renderer is for
};

}  // namespace tyg

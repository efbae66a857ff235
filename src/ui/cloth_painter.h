// The picture of the cloth in the window: the viewer's cloth and what the open panels show on it.
// Must not know: windows, text.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "gfx/passes/sheet_renderer.h"
#include "ui/panels/panels.h"
#include "viewer/viewer.h"

namespace tyg {

/// The wind at the middle of the shown cloth, and where in the window its arrow goes; none where nothing blows.
std::optional<ShownWind> shownWind(const Viewer& viewer);

class ClothPainter {
 public:
  /// A context must be current as long as this lives. `scale`: of the widths of lines and discs. Throws as
  /// SheetRenderer does.
  explicit ClothPainter(const Viewer& viewer, float scale = 1)
      : ClothPainter(viewer, scale, std::make_shared<Programs>()) {}
  /// Into the bound framebuffer. Makes a new renderer where the viewer has another sheet than before.
  void draw(const Viewer& viewer, Panels& panels, Extent window);

 private:
  ClothPainter(const Viewer& viewer, float scale, const std::shared_ptr<Programs>& programs);
  const Sheet& withoutHeld(const ShownState& shown);

  std::shared_ptr<Programs> programs_;
  std::unique_ptr<SheetRenderer> renderer_;
  std::unique_ptr<SheetRenderer> ghost_;  ///< its springs may differ; null until one is shown
  Sheet sheetWithoutHeld_;
  std::vector<float> against_;  ///< of each particle, which way it is moved against its neighbours
  std::vector<Body> bodies_;    ///< as shown
  float scale_;
  int sheet_;  ///< of SceneControl::sheetsSoFar(), the one that the renderer is for
};

}  // namespace tyg

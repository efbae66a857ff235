// Every panel, one line each.
#include <array>

#include "app/panels/control.h"
#include "app/panels/gallery.h"
#include "app/panels/panel.h"

namespace tyg {

std::span<const PanelKind> panelTable() {
  static constexpr std::array kPanels{
      PanelKind{InputAction::OpenControl, "Control", Edge::Left, 21, 0, makeControlPanel},
      PanelKind{InputAction::OpenGallery, "Scenes", Edge::Right, 24, 60, makeGalleryPanel},
  };
  return kPanels;
}

}  // namespace tyg

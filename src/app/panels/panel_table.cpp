// Every panel, one line each.
#include <array>

#include "app/panels/chart.h"
#include "app/panels/control.h"
#include "app/panels/gallery.h"
#include "app/panels/ghost.h"
#include "app/panels/panel.h"

namespace tyg {

std::span<const PanelKind> panelTable() {
  static constexpr std::array kPanels{
      PanelKind{InputAction::OpenControl, "Control", Edge::Left, 21, 0, makeControlPanel},
      PanelKind{InputAction::OpenGallery, "Scenes", Edge::Right, 24, 60, makeGalleryPanel},
      PanelKind{InputAction::OpenChart, "Chart", Edge::Right, 32, 0, makeChartPanel},
      PanelKind{InputAction::OpenGhost, "Ghost", Edge::Right, 22, 0, makeGhostPanel},
  };
  return kPanels;
}

}  // namespace tyg

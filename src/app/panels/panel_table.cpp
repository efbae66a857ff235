// Every panel, one line each.
#include <array>

#include "app/panels/chart.h"
#include "app/panels/control.h"
#include "app/panels/energy.h"
#include "app/panels/gallery.h"
#include "app/panels/ghost.h"
#include "app/panels/panel.h"
#include "app/panels/stretch.h"
#include "app/panels/traces.h"

namespace tyg {

std::span<const PanelKind> panelTable() {
  static constexpr std::array kPanels{
      PanelKind{InputAction::OpenControl, "Control", Edge::Left, 21, 0, makeControlPanel},
      PanelKind{InputAction::OpenGallery, "Scenes", Edge::Right, 24, 60, makeGalleryPanel},
      PanelKind{InputAction::OpenChart, "Chart", Edge::Right, 32, 0, makeChartPanel},
      PanelKind{InputAction::OpenGhost, "Ghost", Edge::Right, 22, 0, makeGhostPanel},
      PanelKind{InputAction::OpenStretch, "Stretch", Edge::Right, 22, 0, makeStretchPanel},
      PanelKind{InputAction::OpenEnergy, "Energy", Edge::Right, 26, 0, makeEnergyPanel},
      PanelKind{InputAction::OpenTraces, "Traces", Edge::Right, 24, 0, makeTracesPanel},
  };
  return kPanels;
}

}  // namespace tyg

// Every panel, one line each.
#include <array>

#include "ui/panels/chart.h"
#include "ui/panels/control.h"
#include "ui/panels/energy.h"
#include "ui/panels/gallery.h"
#include "ui/panels/ghost.h"
#include "ui/panels/panel.h"
#include "ui/panels/stretch.h"
#include "ui/panels/traces.h"

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

// A change is live where the scenes are equal but for method, step and live parameters.
#include "viewer/scene_change.h"

#include "core/simulation/live_parameters.h"

namespace tyg {

SceneChange changeBetween(const Scene& from, const Scene& to) {
  if (from == to) return SceneChange::None;
  const bool sameSheet = from.name == to.name && from.columns == to.columns && from.rows == to.rows &&
                         from.spacing == to.spacing && from.start == to.start && from.pins == to.pins;
  if (!sameSheet) return SceneChange::NewSheet;
  Scene alike = from;
  alike.integrator = to.integrator;
  alike.dt = to.dt;
  copyLiveParameters(to, alike);
  return alike == to ? SceneChange::Live : SceneChange::Restart;
}

}  // namespace tyg

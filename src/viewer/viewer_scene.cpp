// What the viewer does when the scene itself is changed: on with it at once, or from the start.
// Must not know: who changes it.
#include <utility>

#include "core/simulation/live_parameters.h"
#include "tyg/methods.h"
#include "viewer/room.h"
#include "viewer/viewer.h"

namespace tyg {

SceneChange Viewer::use(const Scene& scene) {
  if (seeking_) return SceneChange::None;
  const SceneChange change = changeBetween(scene_, scene);
  try {
    if (change == SceneChange::Live) useLive(scene);
    if (change > SceneChange::Live) begin(scene, change == SceneChange::NewSheet);
  } catch (const std::exception& error) {
    warn(error.what());
    return SceneChange::None;
  }
  return change;
}

/// Another method, step or world. A frozen simulation stays as it is: they are for the next run.
void Viewer::useLive(const Scene& scene) {
  useMethod(findMethod(scene.integrator));
  if (scene.dt != scene_.dt) useStep(scene.dt);
  if (state_ != RunState::Frozen && !sameLiveParameters(scene, simulation_.scene())) {
    beforeDeed();
    simulation_.useLiveParameters(scene);
  }
  scene_ = scene;
  fitCure();
}

void Viewer::followLedger(bool on) {
  settings_.ledger = on;
  simulation_.followLedger(on);
}

void Viewer::begin(const Scene& scene, bool newSheet) {
  const Method& method = findMethod(scene.integrator);
  Simulation fresh(scene, method, settings_);  // first: it may refuse the scene
  const bool running = state_ == RunState::Running;
  scene_ = scene;
  method_ = &method;
  startOver(std::move(fresh));
  if (running) startOrPause();
  if (!newSheet) return;
  ++sheetsSoFar_;
  picked_ = -1;
  room_ = roomOf(simulation_, box_, settings_, clock_);
  frameCloth();
}

}  // namespace tyg

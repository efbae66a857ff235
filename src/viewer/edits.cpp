// Versions of the setup, compared once a frame; undo, redo and reset hand one back to the viewer.
#include "viewer/edits.h"

#include <utility>

#include "core/scene/scene_writer.h"
#include "util/file_names.h"
#include "util/whole_file.h"

namespace tyg {

void Edits::follow(const Viewer& viewer) {
  if (viewer.run().seeking() || viewer.run().timeline().past || viewer.keyHeld() || viewer.tools().pressed())
    return;  // in the past: it was set then, not now
  if (std::exchange(run_, viewer.scenes().runsSoFar()) != viewer.scenes().runsSoFar()) {
    versions_.rewrite([](Setup& setup) { setup.hands = {}; });  // of a run that is over
  }
  originals_.try_emplace(viewer.scenes().scene().name, viewer.scenes().scene());
  const Setup& known = versions_.present();  // compared where it is: a frame copies no scene
  if (known.scene != viewer.scenes().scene() || known.pushFactor != viewer.tools().strength() ||
      known.hands != handWork(viewer.run().simulation().log()))
    versions_.note(setupOf(viewer));
}

const Scene& Edits::original(const Viewer& viewer) const {
  const auto found = originals_.find(viewer.scenes().scene().name);
  return found == originals_.end() ? viewer.scenes().scene() : found->second;
}

void Edits::apply(const Setup& setup, Viewer& viewer) {
  const int run = viewer.scenes().runsSoFar();
  viewer.scenes().use(setup.scene);
  viewer.tools().setStrength(setup.pushFactor);
  const HandWork hands = handWork(viewer.run().simulation().log());
  const bool sameRun = run == viewer.scenes().runsSoFar();
  if (sameRun && hands != setup.hands && viewer.run().state() != RunState::Frozen) {
    applyHandWork(hands, setup.hands, viewer.run().intervene());
  }
}

std::filesystem::path saveScene(const Viewer& viewer) {
  std::filesystem::path path = freeName("", fileStem(viewer.scenes().scene().name), ".toml");
  writeWholeFile(path, sceneToToml(viewer.scenes().scene()));
  return path;
}

}  // namespace tyg

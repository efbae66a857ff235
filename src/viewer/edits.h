// What a person has changed in a running window, by whatever means, so that it can be undone, done again, taken back to
// the scene's own values and kept as a file. Must not know: windows, widgets.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "viewer/hand_work.h"
#include "viewer/undo.h"
#include "viewer/viewer.h"

namespace tyg {

/// Everything that can be set in the window, and what hands have done to the cloth in the present run.
struct Setup {
  Scene scene;
  double pushFactor = 1;
  HandWork hands{};
  bool operator==(const Setup&) const = default;
};

class Edits {
 public:
  explicit Edits(const Viewer& viewer) : versions_(setupOf(viewer)) { follow(viewer); }

  /// To be called once a frame, but not while a slider is held: everything that differs since the last call is one
  /// change. While a key or the button of a tool is held nothing is noted, so that all it does is one change as well.
  void follow(const Viewer& viewer);
  [[nodiscard]] bool canUndo() const { return versions_.canUndo(); }
  [[nodiscard]] bool canRedo() const { return versions_.canRedo(); }
  void undo(Viewer& viewer) {
    if (!viewer.run().seeking()) apply(versions_.undo(), viewer);
  }
  void redo(Viewer& viewer) {
    if (!viewer.run().seeking()) apply(versions_.redo(), viewer);
  }
  /// The scene as it was when the window first had it.
  [[nodiscard]] const Scene& original(const Viewer& viewer) const;
  /// Cuts and pins by hand stay; a restart is without them.
  [[nodiscard]] bool canReset(const Viewer& viewer) const {
    return viewer.scenes().scene() != original(viewer) || viewer.tools().strength() != 1;
  }
  void reset(Viewer& viewer) const { apply({original(viewer), 1, handWork(viewer.run().simulation().log())}, viewer); }

 private:
  static Setup setupOf(const Viewer& viewer) {
    return {viewer.scenes().scene(), viewer.tools().strength(), handWork(viewer.run().simulation().log())};
  }
  static void apply(const Setup& setup, Viewer& viewer);

  UndoStack<Setup> versions_;
  int run_ = 0;                             ///< of SceneControl::runsSoFar(), the one that the hand work is of
  std::map<std::string, Scene> originals_;  ///< by scene name
};

/// Writes the viewer's scene as .toml into the current folder, under a name of its own. Throws InputError.
std::filesystem::path saveScene(const Viewer& viewer);

}  // namespace tyg

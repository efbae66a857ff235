// What has become of a sheet since a run began: particles that are pinned, freed or held, and what was cut. A regular
// type, so that a checkpoint is a copy. Must not know: methods, forces.
#pragma once

#include <span>
#include <vector>

#include "core/simulation/instant.h"
#include "tyg/scene.h"
#include "tyg/sheet.h"

namespace tyg {

class SheetChanges {
 public:
  SheetChanges(const Scene& scene, const Sheet& sheet);

  /// Pins a particle, or frees it; it may already be so.
  void pin(int particle, bool pinned);
  /// A hand takes hold of a particle, or lets it go. Returns whether that is new.
  bool hold(int particle);
  bool release(int particle);
  void cut(const CutLine& line);
  /// Takes the last cuts by hand back, as many of them as there are.
  void mend(int cuts);
  /// Makes the cuts of the scene whose time has come; they were not made before.
  void cutOfScene(const Scene& scene, const Instant& now);

  /// Breaks the springs that were found too long, in this order, each with what a cut along its dual edge takes: from
  /// half a cell before to half a cell behind its middle, at a right angle to it. What one of them takes breaks no
  /// more.
  void tear(std::span<const SpringEnds> tooLong);

  /// The sheet as it is now.
  [[nodiscard]] const Sheet& sheet() const { return sheet_; }
  [[nodiscard]] bool holds(int particle) const;
  [[nodiscard]] std::span<const int> held() const { return held_; }  ///< ascending
  /// By hand, that are not taken back.
  [[nodiscard]] int cuts() const { return static_cast<int>(beforeCuts_.size()); }

 private:
  void gatherPins();
  /// What a hand takes back later stays cut here.
  void cutForGood(const CutLine& line);

  Sheet sheet_;
  std::vector<int> pins_, held_;     ///< ascending
  std::vector<Missing> beforeCuts_;  ///< by hand, for each of them
  std::vector<std::size_t> toCome_;  ///< cuts of the scene, the next one last
};

}  // namespace tyg

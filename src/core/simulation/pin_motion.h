// The pins of a scene that move: when, how fast, and where they must be. A regular type, so that a checkpoint is a
// copy. Must not know: methods, forces.
#pragma once

#include <vector>

#include "core/simulation/backend.h"
#include "core/simulation/instant.h"

namespace tyg {

class PinMotion {
 public:
  /// Throws InputError where a motion names what is not pinned.
  PinMotion(const Scene& scene, const Sheet& sheet);

  /// Gives the pins whose motion begins or ends now their new velocities, and puts them where exact arithmetic would
  /// have brought them. Returns whether there were any.
  bool switchAt(const Scene& scene, const Sheet& sheet, const Instant& now, Backend& backend);
  /// The pins that move now, ascending.
  [[nodiscard]] std::vector<int> moving() const;
  /// What the jumps of their kinetic energy have brought so far, J.
  [[nodiscard]] double work() const { return work_; }

 private:
  struct Pin {
    int particle = 0;
    Vec3 velocity;  ///< m/s, since then:
    double since = 0;
    Vec3 from;  ///< where it was then, m
  };

  std::vector<Pin> pins_;  ///< all that ever move, ascending
  double work_ = 0;
};

}  // namespace tyg

// The pins of a scene that move: when, how fast, and where they must be. A regular type, so that a checkpoint is a
// copy. Must not know: methods, forces.
#pragma once

#include <optional>
#include <vector>

#include "core/simulation/backend.h"
#include "core/simulation/instant.h"

namespace tyg {

class PinMotion {
 public:
  /// Throws InputError where a motion names what is not pinned.
  PinMotion(const Scene& scene, const Sheet& sheet);

  /// A hand holds a particle, which is a pin meanwhile, and moves it with this velocity (m/s), whatever the scene says;
  /// or holds it no longer. Takes effect with switchAt().
  void hold(int particle, const Vec3& velocity);
  void release(int particle);

  /// Gives the pins whose motion begins or ends now their new velocities, and puts them where exact arithmetic would
  /// have brought them. Returns whether there were any.
  bool switchAt(const Scene& scene, const Sheet& sheet, const Instant& now, Backend& backend);
  /// A particle that moved has become a pin and stands still.
  void stop(int particle, const Sheet& sheet, Backend& backend);
  /// Whether there is anything that moves, or may.
  [[nodiscard]] bool any() const { return !pins_.empty(); }
  /// The pins that move now, ascending.
  [[nodiscard]] std::vector<int> moving() const;
  /// What the jumps of their kinetic energy have brought so far, J.
  [[nodiscard]] double work() const { return work_; }

 private:
  struct Pin {
    int particle = 0;
    Vec3 velocity;  ///< m/s, since then:
    double since = 0;
    Vec3 from;                     ///< where it was then, m
    std::optional<Vec3> byHand{};  ///< the velocity that a hand gives it
    bool isNew = false;            ///< its velocity is not yet what is said here
  };
  [[nodiscard]] std::vector<Vec3> wantedAt(const Scene& scene, const Sheet& sheet, const Instant& now) const;

  std::vector<Pin> pins_;  ///< all that ever move, ascending
  double work_ = 0;
};

}  // namespace tyg

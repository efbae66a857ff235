// A grab: one particle follows the cursor in a plane that faces the viewer, until it is let go.
// Must not know: windows, which tool grabs.
#pragma once

#include <cstdint>

#include <glm/glm.hpp>

#include "viewer/held_point.h"
#include "viewer/tool.h"

namespace tyg {

/// The particle is a pin that moves while it is held. Before the ticks of a frame it gets the velocity that takes it to
/// where the cursor wants it; only velocities are in the run's log, neither camera nor cursor.
class Grab {
 public:
  /// Takes hold of a particle, which stays `aside` of the cursor (pixels) from then on. Where time stands still the
  /// grab waits until it passes.
  void begin(const ToolScope& scope, int particle, glm::vec2 cursor, glm::vec2 aside);
  void move(glm::vec2 cursor) { point_.move(cursor); }
  /// Farther by so many notches of the wheel.
  void pushAway(float notches) { point_.pushAway(notches); }
  /// The particle flies on with the velocity that it has.
  void release(const ToolScope& scope);
  /// The run is over: there is nothing to let go of.
  void forget() { holds_ = false; }
  /// See Tool. A cloth that is frozen or shown as it was in the past is let go of.
  void frame(const ToolScope& scope);
  std::int64_t follow(Simulation& simulation, std::int64_t due);

  [[nodiscard]] bool holds() const { return holds_; }

 private:
  [[nodiscard]] Vec3 velocityFor(const Simulation& simulation, std::int64_t due) const;

  bool holds_ = false;
  int particle_ = 0;
  HeldPoint point_;
  glm::vec3 wanted_{0};  ///< m
  Vec3 velocity_;        ///< m/s, as last logged
};

}  // namespace tyg

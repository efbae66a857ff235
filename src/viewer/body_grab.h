// A body follows the cursor in a plane that faces the viewer, until it is let go, whatever motion of its own it has. It
// ends up where its place at the start of the run is another one: a live parameter, as the control panel sets it.
// Must not know: windows, which tool grabs.
#pragma once

#include <cstdint>

#include <glm/glm.hpp>

#include "view/picking.h"
#include "viewer/held_point.h"
#include "viewer/tool.h"

namespace tyg {

/// While time passes the body goes in small jumps, each of them an event of the run's log; at most so fast as a hand
/// moves. Where time stands still it is at once where the cursor wants it.
class BodyGrab {
 public:
  /// The first body that the line of sight through the cursor meets, where the particle under the cursor does not hide
  /// it: one that lies on the body does.
  static std::optional<PickedBody> bodyAt(const ToolScope& scope, glm::vec2 cursor, std::optional<int> particle);

  /// Whether the place of that body is a live parameter: those of the first ones are.
  static bool canMove(const Scene& scene, std::size_t body);
  /// Of one that can be moved.
  void begin(const ToolScope& scope, const PickedBody& picked, glm::vec2 cursor);
  void move(glm::vec2 cursor) { point_.move(cursor); }
  /// Farther by so many notches of the wheel.
  void pushAway(float notches) { point_.pushAway(notches); }
  void release() { holds_ = false; }
  /// See Tool. A body of a cloth that is frozen or shown as it was in the past is let go of.
  void frame(const ToolScope& scope);
  std::int64_t follow(Simulation& simulation, std::int64_t due);

  [[nodiscard]] bool holds() const { return holds_; }

 private:
  /// From where it is to where it is wanted, m.
  [[nodiscard]] glm::dvec3 way(const Simulation& simulation) const;
  void jump(Simulation& simulation, const glm::dvec3& by);

  bool holds_ = false;
  std::size_t body_ = 0;
  HeldPoint point_;
  glm::dvec3 aside_{0};       ///< m, from the point that is held to the body's place
  glm::dvec3 wanted_{0};      ///< m, of the body's place
  glm::dvec3 velocity_{0};    ///< m/s, by the hand in this frame
  bool isNewFrame_ = false;   ///< and nothing has been done in it yet
  std::int64_t movedAt_ = 0;  ///< the tick up to which the body has gone its way
};

}  // namespace tyg

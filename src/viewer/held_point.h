// A point that follows the cursor in a plane that faces the viewer, as what a hand holds does.
// Must not know: what is held, windows.
#pragma once

#include <cstdint>
#include <optional>

#include <glm/glm.hpp>

namespace tyg {

class RunControl;
struct ToolScope;

/// The window that a tool works in, in pixels of the framebuffer.
glm::vec2 windowOf(const ToolScope& scope);

class HeldPoint {
 public:
  /// Takes hold of a point (m), which stays `aside` of the cursor (pixels) from then on: a running cloth wakes, and a
  /// replay ends. Returns false behind the eye, and then does nothing.
  bool begin(const ToolScope& scope, const glm::vec3& point, glm::vec2 cursor, glm::vec2 aside);
  /// Once a frame: whether the hand loses its hold, since the cloth is frozen, shown as it was in the past, or has gone
  /// back there.
  bool slips(const RunControl& run);
  void move(glm::vec2 cursor) { cursor_ = cursor; }
  /// Farther by so many notches of the wheel.
  void pushAway(float notches);
  /// Where the cursor wants the point, m; nothing where no such place is finite.
  [[nodiscard]] std::optional<glm::vec3> wanted(const ToolScope& scope);

 private:
  glm::vec2 cursor_{0}, aside_{0};  ///< pixels; from the cursor to the point
  float depth_ = 1;                 ///< m, from the eye along the direction in which it looks
  std::int64_t tick_ = 0;           ///< of the last frame
};

/// The velocity (m/s) that takes what is held evenly along this way (m), where a frame lasts so many seconds. At most
/// as fast as a hand moves along a sheet of this size (m).
glm::dvec3 handVelocity(const glm::dvec3& way, double seconds, double size);

}  // namespace tyg

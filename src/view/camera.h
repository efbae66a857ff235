// A free-flying camera: where the eye is, where it looks, and how keys, mouse and wheel move it.
// Must not know: OpenGL, windows, clocks. No input, however strange, makes it anything but finite.
#pragma once

#include <optional>
#include <span>

#include <glm/glm.hpp>

#include "view/box.h"

namespace tyg {

/// Keys held down, each -1, 0 or 1 (anything between is slower): D - A, E - Q, W - S, and the arrow keys.
struct Motion {
  float right = 0, up = 0, forward = 0;
  float lookRight = 0, lookUp = 0;
  bool operator==(const Motion&) const = default;
};

/// The part of a picture that is free for the cloth, in heights of the picture.
struct FreePart {
  float width = 1, height = 1;      ///< > 0
  float toTheRight = 0, above = 0;  ///< from the middle of the picture to the middle of that part
  bool operator==(const FreePart&) const = default;
};

class Camera {
 public:
  /// Looks from the front, a little from the right and above: the pleasant three-quarter view. Call frame() next.
  Camera() = default;

  /// Where the cloth is now: speed, nearest and farthest distance drawn follow it. Once a frame.
  void watch(const Box& cloth);
  /// Moves the eye, keeping its direction, so that the box just fits a window of this aspect (width / height, > 0) with
  /// a margin; watches that box as well.
  void frame(const Box& cloth, float aspect);
  /// The same for points (closer than their box would allow). No points: nothing happens.
  void frame(std::span<const glm::vec3> points, float aspect) { frame(points, FreePart{.width = aspect}); }
  /// The same for a part of the picture.
  void frame(std::span<const glm::vec3> points, const FreePart& part);
  /// Moves the eye, keeping its direction, no farther than it must for all points to be seen in that part of the
  /// picture.
  void keepInView(std::span<const glm::vec3> points, const FreePart& part);
  /// Moves sideways, so that the cloth is seen so many heights of the picture farther to the right and farther up.
  void slide(float toTheRight, float up);

  /// Puts the eye there, keeping its direction. Ignored where it is not finite.
  void place(const glm::vec3& eye);
  /// Looks along this direction. yaw in radians (0 looks to -z, positive turns right), pitch in radians (positive up,
  /// clamped to 89 degrees). Values that are not finite are ignored.
  void lookAlong(float yaw, float pitch);
  /// Turns by mouse pixels: right and down are positive.
  void turn(float pixelsRight, float pixelsDown);
  /// Flies around a point (m), which stays where it is seen, as if the cloth were turned about it by the mouse.
  void orbit(float pixelsRight, float pixelsDown, const glm::vec3& about);
  /// Flies and turns for `seconds` (>= 0, taken as at most 0.1): right and forward along the eye's axes, up along the
  /// world's.
  void move(const Motion& keys, float seconds);
  /// Moves along the line of sight by wheel notches: positive is nearer, each a fixed share of the distance.
  void approach(float notches);

  [[nodiscard]] glm::vec3 eye() const { return eye_; }
  [[nodiscard]] glm::vec3 forward() const;  ///< unit vector
  [[nodiscard]] glm::vec3 right() const;    ///< unit vector, horizontal
  [[nodiscard]] glm::vec3 up() const;       ///< unit vector
  [[nodiscard]] float yaw() const { return yaw_; }
  [[nodiscard]] float pitch() const { return pitch_; }
  [[nodiscard]] float fieldOfView() const { return fieldOfView_; }  ///< vertical, radians
  [[nodiscard]] const Box& watched() const { return cloth_; }
  /// Distance from the eye to the middle of the cloth, never below a twentieth of its size, m.
  [[nodiscard]] float distance() const;

  [[nodiscard]] glm::mat4 view() const;
  /// OpenGL's clip space (z from -1 to 1). `aspect` that is not above zero counts as 1 (a minimised window).
  [[nodiscard]] glm::mat4 projection(float aspect) const { return projection(aspect, nearest()); }
  /// The same from another distance on, m, > 0.
  [[nodiscard]] glm::mat4 projection(float aspect, float from) const;
  /// The distances between which things are drawn, m: both follow the distance to the cloth.
  [[nodiscard]] float nearest() const { return nearest(cloth_); }
  [[nodiscard]] float farthest() const;
  /// nearest() for something else than the cloth, within this box.
  [[nodiscard]] float nearest(const Box& thing) const;

 private:
  void keepInReach();

  glm::vec3 eye_{1.6F, 0.8F, 2.4F};
  float yaw_ = -0.55F, pitch_ = -0.36F;
  float fieldOfView_ = 0.7854F;
  Box cloth_;
};

/// An arrow at the window's edge, in pixels from its top left corner.
struct EdgeArrow {
  glm::vec2 tip;        ///< `margin` inside the edge
  glm::vec2 direction;  ///< unit vector, y down
};
/// Where an arrow must point to find a cloth that lies wholly outside the window or behind the eye; nothing while any
/// of its box may be in view. `window` in pixels.
std::optional<EdgeArrow> edgeArrow(const Camera& camera, const Box& cloth, glm::vec2 window, float margin);

}  // namespace tyg

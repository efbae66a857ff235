// Every position passes finiteOr and every angle a check before it is kept, so that the camera stays finite.
#include "view/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/gtc/matrix_transform.hpp>

namespace tyg {
namespace {

constexpr float kSteepest = 1.5533F;       // 89 degrees: straight up has no right-hand side
constexpr float kTurnPerPixel = 0.0035F;   // radians: half a turn in about 900 pixels
constexpr float kOrbitPerPixel = 0.007F;   // radians: half a turn in about 450 pixels
constexpr float kTurnPerSecond = 1.2F;     // radians, by keys
constexpr float kSpeedPerDistance = 0.9F;  // distances to the cloth flown in a second
constexpr float kLongestMove = 0.1F;       // s: a stalled frame must not throw the eye across the scene
constexpr float kNotchShare = 0.88F;       // of the distance that is left after one wheel notch
constexpr float kMostNotches = 20;
constexpr float kReach = 500;           // cloth sizes that the eye may fly away
constexpr float kFarthest = 1e12F;      // m: squares of larger numbers come near overflow
constexpr float kMargin = 1.12F;        // how much larger than the cloth a framed view is
constexpr float kNarrowMargin = 1.08F;  // likewise one that is moved no farther than it must

bool finite(float a, float b) { return std::isfinite(a) && std::isfinite(b); }

glm::vec3 finiteOr(const glm::vec3& v, const glm::vec3& otherwise) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) ? v : otherwise;
}

/// The slope of the line of sight so many heights of the picture from its middle; 0 where they are not finite.
float slopeOf(const Camera& camera, float heights) {
  return std::isfinite(heights) ? 2 * std::tan(camera.fieldOfView() / 2) * heights : 0;
}

/// One pair of a frustum's side planes, left and right or below and above, and how far points reach beyond it. A point
/// p is between them where |across(p) - across(eye)| <= slope (depth(p) - depth(eye)); across is measured from the
/// plane through the middle of the free part, which is slanted.
class SidePlanes {
 public:
  SidePlanes(const glm::vec3& across, const glm::vec3& ahead, float slope, std::span<const glm::vec3> points)
      : across_(across), ahead_(ahead), slope_(slope), points_(points) {
    for (const glm::vec3& p : points) {
      low_ = std::max(low_, -acrossOf(p) - slope * depthOf(p));
      high_ = std::max(high_, acrossOf(p) - slope * depthOf(p));
    }
  }

  /// The greatest depth of an eye that has all points between the planes.
  [[nodiscard]] float eyeDepth() const { return -(high_ + low_) / (2 * slope_); }
  /// The place nearest to `wanted` of an eye at this depth, at most eyeDepth(), that has them there.
  [[nodiscard]] float nearestAcross(float wanted, float depth) const {
    return std::min(std::max(wanted, high_ + slope_ * depth), -low_ - slope_ * depth);
  }
  /// Where an eye at this depth, which is less than eyeDepth(), has as much space left of the points as right of them.
  /// That difference falls as the eye moves right, so that halving finds where it is 0.
  [[nodiscard]] float middleAcross(float depth) const {
    float left = high_ + slope_ * depth, right = -low_ - slope_ * depth;
    constexpr int kHalvings = 24;  // to the last bit of a float
    for (int k = 0; k < kHalvings; ++k) {
      const float middle = (left + right) / 2;
      float least = std::numeric_limits<float>::infinity(), most = -least;
      for (const glm::vec3& p : points_) {
        const float slope = (acrossOf(p) - middle) / (depthOf(p) - depth);
        least = std::min(least, slope), most = std::max(most, slope);
      }
      (least + most > 0 ? left : right) = middle;
    }
    return (left + right) / 2;
  }
  [[nodiscard]] float acrossOf(const glm::vec3& p) const { return glm::dot(p, across_); }
  [[nodiscard]] float depthOf(const glm::vec3& p) const { return glm::dot(p, ahead_); }

 private:
  glm::vec3 across_, ahead_;
  float slope_;
  std::span<const glm::vec3> points_;
  float low_ = -std::numeric_limits<float>::infinity(), high_ = low_;
};

/// The planes at the sides of that part of the picture, and those below and above it.
struct Sides {
  Sides(const Camera& camera, std::span<const glm::vec3> points, const FreePart& part, float margin)
      : slantX(slopeOf(camera, part.toTheRight)),
        slantY(slopeOf(camera, part.above)),
        x(camera.right() - slantX * camera.forward(), camera.forward(), slope(camera, part.width, margin), points),
        y(camera.up() - slantY * camera.forward(), camera.forward(), slope(camera, part.height, margin), points) {}
  static float slope(const Camera& camera, float extent, float margin) {
    return std::tan(camera.fieldOfView() / 2) / margin * (extent > 0 && std::isfinite(extent) ? extent : 1.0F);
  }
  float slantX, slantY;
  SidePlanes x, y;
};

}  // namespace

void Camera::watch(const Box& cloth) {
  const glm::vec3 low = finiteOr(cloth.low, cloth_.low), high = finiteOr(cloth.high, cloth_.high);
  const glm::vec3 most(kFarthest);
  cloth_ = {glm::clamp(glm::min(low, high), -most, most), glm::clamp(glm::max(low, high), -most, most)};
  keepInReach();
}

void Camera::frame(const Box& cloth, float aspect) {
  watch(cloth);
  const auto corners = cloth_.corners();
  frame(std::span<const glm::vec3>(corners), aspect);
}

void Camera::slide(float toTheRight, float high) {
  eye_ = finiteOr(eye_ - distance() * (slopeOf(*this, toTheRight) * right() + slopeOf(*this, high) * up()), eye_);
  keepInReach();
}

void Camera::frame(std::span<const glm::vec3> points, const FreePart& part) {
  // Each pair of planes has an eye that just satisfies it; the one that lies farther back satisfies both.
  const Sides sides(*this, points, part, kMargin);
  // A cloth without extent still gets some space around it.
  const float back = std::min(sides.x.eyeDepth(), sides.y.eyeDepth()) - 0.05F * cloth_.size();
  if (points.empty() || !std::isfinite(back)) return;
  const float across = sides.x.middleAcross(back) + sides.slantX * back;
  const float high = sides.y.middleAcross(back) + sides.slantY * back;
  eye_ = finiteOr(across * right() + high * up() + back * forward(), eye_);
  keepInReach();
}

void Camera::keepInView(std::span<const glm::vec3> points, const FreePart& part) {
  const Sides sides(*this, points, part, kNarrowMargin);
  const float depth = glm::dot(eye_, forward());
  const float back = std::min({depth, sides.x.eyeDepth(), sides.y.eyeDepth()});
  if (points.empty() || !std::isfinite(back)) return;
  // Straight back first, then aside. All of it is exactly 0 where all points are seen.
  const auto aside = [&](const SidePlanes& planes, float slant) {
    const float across = planes.acrossOf(eye_) + slant * (depth - back);
    return planes.nearestAcross(across, back) - across;
  };
  const float toTheRight = aside(sides.x, sides.slantX), high = aside(sides.y, sides.slantY);
  eye_ = finiteOr(eye_ + toTheRight * right() + high * up() + (back - depth) * forward(), eye_);
  keepInReach();
}

void Camera::place(const glm::vec3& eye) {
  eye_ = finiteOr(eye, eye_);
  keepInReach();
}

void Camera::lookAlong(float yaw, float pitch) {
  if (finite(yaw, pitch)) {
    yaw_ = std::remainder(yaw, 2 * 3.14159265F);
    pitch_ = std::clamp(pitch, -kSteepest, kSteepest);
  }
}

void Camera::turn(float pixelsRight, float pixelsDown) {
  lookAlong(yaw_ + kTurnPerPixel * pixelsRight, pitch_ - kTurnPerPixel * pixelsDown);
}

void Camera::orbit(float pixelsRight, float pixelsDown, const glm::vec3& about) {
  const glm::vec3 away = about - eye_;
  const glm::vec3 seen(glm::dot(away, right()), glm::dot(away, up()), glm::dot(away, forward()));
  const float more = kOrbitPerPixel / kTurnPerPixel;
  turn(more * pixelsRight, more * pixelsDown);
  eye_ = finiteOr(about - seen.x * right() - seen.y * up() - seen.z * forward(), eye_);
  keepInReach();
}

void Camera::move(const Motion& keys, float seconds) {
  seconds = std::clamp(seconds, 0.0F, kLongestMove);
  lookAlong(yaw_ + kTurnPerSecond * seconds * keys.lookRight, pitch_ + kTurnPerSecond * seconds * keys.lookUp);
  const float way = kSpeedPerDistance * distance() * seconds;
  const glm::vec3 direction = keys.right * right() + keys.up * glm::vec3(0, 1, 0) + keys.forward * forward();
  eye_ = finiteOr(eye_ + way * direction, eye_);
  keepInReach();
}

void Camera::approach(float notches) {
  const float share = 1 - std::pow(kNotchShare, std::clamp(notches, -kMostNotches, kMostNotches));
  eye_ = finiteOr(eye_ + share * distance() * forward(), eye_);
  keepInReach();
}

void Camera::keepInReach() {
  const glm::vec3 away = eye_ - cloth_.centre();
  const float farthestEye = kReach * cloth_.size();
  if (glm::length(away) > farthestEye) {
    eye_ = cloth_.centre() + farthestEye * glm::normalize(away);
  }
}

glm::vec3 Camera::forward() const {
  return {std::sin(yaw_) * std::cos(pitch_), std::sin(pitch_), -std::cos(yaw_) * std::cos(pitch_)};
}
glm::vec3 Camera::right() const { return {std::cos(yaw_), 0, std::sin(yaw_)}; }
glm::vec3 Camera::up() const { return glm::cross(right(), forward()); }

float Camera::distance() const { return std::max(glm::distance(eye_, cloth_.centre()), 0.05F * cloth_.size()); }

glm::mat4 Camera::view() const {
  // From the axes, not from a point ahead of the eye: far out, eye + forward rounds to the eye itself.
  const glm::mat3 axes = glm::transpose(glm::mat3(right(), up(), -forward()));
  glm::mat4 view(axes);
  view[3] = glm::vec4(axes * -eye_, 1);
  return view;
}

glm::mat4 Camera::projection(float aspect, float from) const {
  return glm::perspective(fieldOfView_, aspect > 0 && std::isfinite(aspect) ? aspect : 1.0F, from, farthest());
}

float Camera::nearest(const Box& thing) const {
  const glm::vec3 toBox = glm::max(glm::max(thing.low - eye_, eye_ - thing.high), glm::vec3(0));
  return std::max(0.3F * glm::length(toBox), 0.002F * cloth_.size());
}
float Camera::farthest() const { return 4 * distance() + 30 * cloth_.size(); }

std::optional<EdgeArrow> edgeArrow(const Camera& camera, const Box& cloth, glm::vec2 window, float margin) {
  if (!(window.x > 2 * margin && window.y > 2 * margin)) {
    return std::nullopt;
  }
  const glm::mat4 view = camera.view();
  const float slopeY = std::tan(camera.fieldOfView() / 2), slopeX = slopeY * window.x / window.y;
  // Outside when all corners lie beyond one and the same plane of the frustum: left, right, below, above, behind.
  std::array<bool, 5> allBeyond{true, true, true, true, true};
  for (const glm::vec3& corner : cloth.corners()) {
    const glm::vec3 p = glm::vec3(view * glm::vec4(corner, 1));
    const std::array<bool, 5> beyond{p.x < slopeX * p.z, -p.x < slopeX * p.z, p.y < slopeY * p.z,
                                     -p.y<slopeY * p.z, p.z> 0};
    for (std::size_t i = 0; i < beyond.size(); ++i) {
      allBeyond[i] = allBeyond[i] && beyond[i];
    }
  }
  if (std::none_of(allBeyond.begin(), allBeyond.end(), [](bool outside) { return outside; })) {
    return std::nullopt;
  }
  const glm::vec3 centre = glm::vec3(view * glm::vec4(cloth.centre(), 1));
  const glm::vec2 aside(centre.x, -centre.y);
  // Exactly behind every way is as long; right is as good as any.
  const glm::vec2 direction = glm::length(aside) > 1e-6F * cloth.size() ? glm::normalize(aside) : glm::vec2(1, 0);
  const glm::vec2 half = window / 2.0F - margin;
  const glm::vec2 stretch = half / glm::max(glm::abs(direction), glm::vec2(1e-6F));
  return EdgeArrow{window / 2.0F + direction * std::min(stretch.x, stretch.y), direction};
}

}  // namespace tyg

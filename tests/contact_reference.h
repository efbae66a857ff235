// Contact as docs/model.md, section 3, has it, written down a second time: plain formulas, one particle at a time, and
// a classical Runge-Kutta method. Must not know: how the program computes contact.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "test_systems.h"

namespace tyg::test {

/// S(u): the integral of the quintic smooth step 6 c^5 - 15 c^4 + 10 c^3, and beyond the layer a straight line.
inline double pushShare(double u) {
  if (u <= 0) return 0;
  const double c = std::min(u, 1.0);
  return std::pow(c, 6) - 3 * std::pow(c, 5) + 2.5 * std::pow(c, 4) + (u - c);
}
/// P(u), the integral of S(u).
inline double energyShare(double u) {
  if (u <= 0) return 0;
  const double c = std::min(u, 1.0), past = u - c;
  return std::pow(c, 7) / 7 - std::pow(c, 6) / 2 + std::pow(c, 5) / 2 + past / 2 + past * past / 2;
}
/// The depth at which a body pushes with a force, m, by bisection.
inline double depthOfPush(const Contact& contact, double force) {
  double low = 0, high = contact.layer + 2 * force / contact.stiffness;
  for (int k = 0; k < 200; ++k) {
    const double middle = (low + high) / 2;
    (contact.stiffness * contact.layer * pushShare(middle / contact.layer) < force ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// How deep a place is below the surface, m, and the normal there.
struct Below {
  double depth;
  Vec3 normal;
};
inline Below belowBall(const Vec3& middle, double radius, const Vec3& x) {
  const Vec3 out = x - middle;
  return {radius - length(out), (1 / length(out)) * out};
}
/// The place of the core of a box or of a capsule that is nearest to x.
inline Vec3 nearestOfCore(const Body& body, const Vec3& at, const Vec3& x) {
  const Vec3 out = x - at;
  if (body.shape == Shape::Capsule) {
    const double along = std::clamp(dot(out, body.axis) / dot(body.axis, body.axis), 0.0, 1.0);
    return at + along * body.axis;
  }
  const auto inside = [&](double a, double half) { return std::clamp(a, body.radius - half, half - body.radius); };
  return at + Vec3{inside(out.x, body.half.x), inside(out.y, body.half.y), inside(out.z, body.half.z)};
}
/// Of places outside of a box's core.
inline Below belowBody(const Scene& scene, const Body& body, const Vec3& moved, const Vec3& x) {
  const double flat = scene.spacing * scene.spacing / (4 * body.radius);
  const double gap = scene.contact.gap.value_or(body.shape == Shape::Plane ? 0 : flat);
  const Vec3 at = body.at + moved;
  if (body.shape == Shape::Plane) return {gap - dot(x - at, body.normal), body.normal};
  if (body.shape == Shape::Ball) return belowBall(at, body.radius + gap, x);
  return belowBall(nearestOfCore(body, at, x), body.radius + gap, x);
}

/// What bodies do to the particles of a scene at a time.
class ContactReference {
 public:
  explicit ContactReference(const Scene& scene) : scene_(scene), springs_(scene) {}

  [[nodiscard]] Vec3 forceOn(double time, const Vec3& x, const Vec3& v) const {
    Vec3 sum{};
    for (const Body& body : scene_.bodies) sum = sum + forceOf(body, time, x, v);
    return sum;
  }
  /// Springs, weight, drag and contact, N.
  [[nodiscard]] std::vector<Vec3> force(double time, const Points& at) const {
    std::vector<Vec3> sum = springs_.force(at);
    for (std::size_t i = 0; i < sum.size(); ++i) {
      if (!springs_.pinned(i)) sum[i] = sum[i] + forceOn(time, at.x[i], at.v[i]);
    }
    return sum;
  }
  /// From the time 0 on.
  void advance(Points& at, double seconds, int steps) const {
    const double h = seconds / steps;
    for (int n = 0; n < steps; ++n) {
      const double t = n * h;
      const Points k1 = rate(t, at), k2 = rate(t + h / 2, moved(at, h / 2, k1));
      const Points k3 = rate(t + h / 2, moved(at, h / 2, k2)), k4 = rate(t + h, moved(at, h, k3));
      at = moved(moved(moved(moved(at, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4);
    }
  }

 private:
  [[nodiscard]] Vec3 forceOf(const Body& body, double time, const Vec3& x, const Vec3& v) const {
    Vec3 moved{}, velocity{};
    for (const Move& move : scene_.moves) {
      if (move.body.empty() || move.body != body.name) continue;
      moved = moved + std::clamp(time - move.at, 0.0, move.duration) * move.velocity;
      if (time >= move.at && time < move.at + move.duration) velocity = velocity + move.velocity;
    }
    const Contact& c = scene_.contact;
    const Below below = belowBody(scene_, body, moved, x);
    const double s = pushShare(below.depth / c.layer), push = c.stiffness * c.layer * s;
    if (push == 0) return {};
    const double along = dot(v - velocity, below.normal);
    const Vec3 slip = (v - velocity) - along * below.normal;
    const double damper = 2 * c.damping * std::sqrt(c.stiffness * scene_.particleMass) * s / (s + 0.5);
    const double most = c.friction * push;
    const double rub = most > 0 ? most / std::hypot(length(slip), most / c.grip) : 0;
    return (push - damper * along) * below.normal - rub * slip;
  }
  [[nodiscard]] Points rate(double time, const Points& at) const {
    Points rate{at.v, force(time, at)};
    for (Vec3& a : rate.v) a = (1 / scene_.particleMass) * a;
    return rate;
  }
  static Points moved(Points at, double h, const Points& rate) {
    for (std::size_t i = 0; i < at.x.size(); ++i) {
      at.x[i] = at.x[i] + h * rate.x[i];
      at.v[i] = at.v[i] + h * rate.v[i];
    }
    return at;
  }

  Scene scene_;
  Oracle springs_;
};

/// One free particle of 10 g, a plane through the place where it starts, and gravity.
inline Scene particleOnFloor() {
  Scene scene = emptyWorld(1, 1);
  scene.spacing = 0.01, scene.particleMass = 0.01;
  scene.gravity = {0, -9.81, 0};
  scene.contact = {.stiffness = 100, .layer = 0.005, .damping = 0.3, .friction = 0, .grip = 0.5};
  scene.bodies = {{.shape = Shape::Plane}};
  scene.dt = 1e-3, scene.tolerance = 1e-8;
  return scene;
}

/// A soft sheet that stays in the layers of a plane, of a ball that moves and of a box for a second: nothing in its
/// motion is less than smooth.
inline Scene sheetInLayers() {
  Scene scene = softSheet(Damping::Relative);
  scene.contact = {.stiffness = 20, .layer = 6, .damping = 0.15, .friction = 0.6, .grip = 1.5};
  scene.bodies = {{.shape = Shape::Plane, .at = {0, 4.5, 0}, .normal = {0.0, 0.8, 0.6}},
                  {.shape = Shape::Ball, .at = {0.4, -4, 1}, .radius = 5.5, .name = "ball"},
                  {.shape = Shape::Capsule, .at = {-3, -5, 0}, .axis = {9, 0.5, 1}, .radius = 6.5}};
  scene.moves = {{.velocity = {0.5, 0.3, -0.2}, .at = 0, .duration = 5, .body = "ball"}};
  return scene;
}

}  // namespace tyg::test

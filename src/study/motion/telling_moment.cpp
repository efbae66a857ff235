// The first push, motion or wind says when something happens; a scene without one has swung furthest after a good
// quarter of a swing, or has come to lie on what it falls onto after a second.
#include "study/motion/telling_moment.h"

#include <algorithm>

namespace tyg {

double tellingMoment(const Scene& scene) {
  if (!scene.pushes.empty()) return std::min(scene.pushes[0].at + scene.pushes[0].duration, scene.duration);
  if (!scene.moves.empty()) return std::min(scene.moves[0].at + scene.moves[0].duration, scene.duration);
  if (!scene.winds.empty()) {
    constexpr double kLongEnough = 1.5;  // s, for a wind to have shaped a cloth
    return std::min(scene.winds[0].at + std::min(scene.winds[0].duration, kLongEnough), scene.duration);
  }
  constexpr double kSwing = 0.45, kDrape = 1;  // s
  return std::min(scene.bodies.empty() ? kSwing : kDrape, scene.duration);
}

}  // namespace tyg

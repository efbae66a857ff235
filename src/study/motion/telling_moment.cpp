// The first push says when something happens; a scene without one has swung furthest after a good quarter of a swing.
#include "study/motion/telling_moment.h"

#include <algorithm>

namespace tyg {

double tellingMoment(const Scene& scene) {
  if (!scene.pushes.empty()) return std::min(scene.pushes[0].at + scene.pushes[0].duration, scene.duration);
  return std::min(0.45, scene.duration);
}

}  // namespace tyg

// Coordinates too large to be squared are left out like those that are not finite.
#include "view/box.h"

#include <algorithm>
#include <cmath>

namespace tyg {

float Box::size() const {
  constexpr float kRounding = 1e-6F, kOfAPoint = 1e-3F;  // of the coordinates; m
  const float extent = glm::length(high - low);
  const float rounding = kRounding * std::max(glm::length(low), glm::length(high));
  return extent > rounding ? extent : std::max(rounding, kOfAPoint);
}

std::array<glm::vec3, 8> Box::corners() const {
  std::array<glm::vec3, 8> all;
  for (unsigned i = 0; i < 8; ++i) {
    all[i] = {(i & 1U) != 0 ? high.x : low.x, (i & 2U) != 0 ? high.y : low.y, (i & 4U) != 0 ? high.z : low.z};
  }
  return all;
}

Box Box::with(const Box& other) const { return {glm::min(low, other.low), glm::max(high, other.high)}; }

Box boxAround(std::span<const float> xyz) {
  // Beyond this a square or a difference overflows, and a cloth that far away has blown up anyway.
  constexpr float kFarthest = 1e15F;
  Box box{glm::vec3(kFarthest), glm::vec3(-kFarthest)};
  for (std::size_t i = 0; i + 2 < xyz.size(); i += 3) {
    const glm::vec3 p(xyz[i], xyz[i + 1], xyz[i + 2]);
    const glm::vec3 away = glm::abs(p);
    if (away.x < kFarthest && away.y < kFarthest && away.z < kFarthest) {
      box = box.with({p, p});
    }
  }
  return box.low.x <= box.high.x ? box : Box{};
}

}  // namespace tyg

// The distance of two motions is the largest distance of their particles over all sample times.
#include "study/motion/error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tyg {

Distance distanceBetween(std::span<const Vec3> a, std::span<const Vec3> b) {
  double sum = 0, largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double x = a[i].x - b[i].x, y = a[i].y - b[i].y, z = a[i].z - b[i].z;
    const double square = x * x + y * y + z * z;
    sum += square;
    largest = std::max(largest, square);
  }
  return {std::sqrt(sum / static_cast<double>(a.size())), std::sqrt(largest)};
}

Distance motionError(const SampledMotion& motion, const SampledMotion& reference) {
  if (motion.positions.size() < reference.positions.size()) {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    return {kUnknown, kUnknown};
  }
  Distance error;
  for (std::size_t k = 0; k < reference.positions.size(); ++k) {
    const Distance here = distanceBetween(motion.positions[k], reference.positions[k]);
    error.rms = std::max(error.rms, here.rms);
    error.largest = std::max(error.largest, here.largest);
  }
  return error;
}

}  // namespace tyg

// How far a motion is from another one: the error E of docs/model.md, section 7.
// Must not know: how the motions came about.
#pragma once

#include <span>

#include "study/motion/sampled_motion.h"

namespace tyg {

/// Distances between two sets of positions of the same particles, m.
struct Distance {
  double rms = 0;      ///< root of the mean over particles of |a - b|^2
  double largest = 0;  ///< of any particle
};
/// Both sets must be of one size, and not empty.
Distance distanceBetween(std::span<const Vec3> a, std::span<const Vec3> b);

/// The largest over all sample times of both distances: `rms` is E. NaN where `motion` ended before the reference did.
Distance motionError(const SampledMotion& motion, const SampledMotion& reference);

}  // namespace tyg

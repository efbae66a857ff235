// The few numbers of a motion that still can be compared where single positions are lost: energy, centre of mass and
// gyration radius (docs/model.md, section 7). Must not know: how motions come about, which methods there are.
#pragma once

#include <span>

#include "study/motion/sampled_motion.h"

namespace tyg {

/// A sheet as a whole at one time.
struct Bulk {
  Vec3 centre;          ///< of mass, m
  double gyration = 0;  ///< root of the mean over particles of the squared distance from the centre, m
  double energy = 0;    ///< kinetic, elastic and gravitational, J
};

/// At every sample time of a motion.
std::vector<Bulk> bulkOf(const SampledMotion& motion);

/// How far two motions of one scene are from each other as wholes.
struct BulkDistance {
  double centre = 0, gyration = 0;  ///< m
  double energy = 0;                ///< J
};

/// The largest distances from sample `first` on; NaN where one of the motions ended before the other.
BulkDistance bulkDistance(std::span<const Bulk> a, std::span<const Bulk> b, std::size_t first);

}  // namespace tyg

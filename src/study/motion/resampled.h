// A motion of a sheet, read off at the particles of another grid of the same cloth.
// Must not know: how motions come about.
#pragma once

#include "study/motion/sampled_motion.h"

namespace tyg {

/// `motion` of `from`'s sheet at the particles of `to`: interpolated bilinearly between the four particles around the
/// same fractions of both sides. Where both grids have a particle, it is that particle's very position.
SampledMotion resampled(const SampledMotion& motion, const Scene& from, const Scene& to);

/// A motion's samples up to a time (s); the rest of it is as it was.
SampledMotion upTo(double time, SampledMotion motion);

}  // namespace tyg

// A motion of a sheet at the places of another grid of the same cloth.
// Must not know: how motions come about.
#pragma once

#include "study/motion/sampled_motion.h"

namespace tyg {

/// `motion` of `from`'s sheet at the places of `to`'s particles: bilinear between the four particles around the same
/// fraction of the way along both sides. Where `to` holds a particle of `from`, its very position.
SampledMotion resampled(const SampledMotion& motion, const Scene& from, const Scene& to);

/// A motion's samples up to a time (s); the rest of it is as it was.
SampledMotion upTo(double time, SampledMotion motion);

}  // namespace tyg

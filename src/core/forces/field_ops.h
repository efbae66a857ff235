// One pass over all numbers of a field, shared over the workers: what an integrator's update is written in.
#pragma once

#include "core/forces/state.h"
#include "util/workers.h"

namespace tyg {

/// Calls `op(i)` for the place i, counted from x(), of every number of all three planes, padding included; the
/// same place means the same number in every field of this layout. `op` may read and write that place alone: the calls
/// are shared over the workers and run side by side in the vector units. (Left to find out by itself whether fields
/// overlap, the compiler gives up on loops over many of them and computes number by number.)
template <class Op>
void forNumbers(Workers& workers, const Layout& layout, const Op& op) {
  workers.forBands(layout.rows, [&](int first, int last, int) {
    const Op number = op;  // on the stack, where no store can alias what it holds
    for (int axis = 0; axis < 3; ++axis) {
      const std::ptrdiff_t end = axis * layout.plane + last * layout.stride;
#if defined(__clang__)
#pragma clang loop vectorize(assume_safety)
#else
#pragma GCC ivdep
#endif
      for (std::ptrdiff_t i = axis * layout.plane + first * layout.stride; i < end; ++i) number(i);
    }
  });
}

}  // namespace tyg

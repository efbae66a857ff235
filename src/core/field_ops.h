// One pass over all numbers of a field, shared over the workers: what an integrator's update is written in.
#pragma once

#include "tyg/state.h"
#include "tyg/workers.h"

namespace tyg {

/// Calls `op(begin, end)` for ranges that together cover the numbers of all three planes, pads and ghosts included; the
/// same index means the same number in every field of this layout, counted from x().
template <class Op>
void forNumbers(Workers& workers, const Layout& layout, const Op& op) {
  workers.forBands(layout.rows, [&](int first, int last, int) {
    for (int axis = 0; axis < 3; ++axis) {
      op(axis * layout.plane + first * layout.stride, axis * layout.plane + last * layout.stride);
    }
  });
}

}  // namespace tyg

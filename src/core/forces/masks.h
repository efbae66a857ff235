// Ones and zeros by which the row kernels multiply what is not there, in place of branches.
// Must not know: forces.
#pragma once

#include "core/forces/state.h"

namespace tyg {

/// 1 for every column that has a neighbour `distance` to the right.
template <class T>
AlignedVector<T> columnMask(const Layout& layout, int distance) {
  AlignedVector<T> mask(static_cast<std::size_t>(layout.stride));
  for (int column = 0; column + distance < layout.columns; ++column) mask[static_cast<std::size_t>(column)] = T(1);
  return mask;
}

/// 1 for every particle of the sheet that is not pinned.
template <class T>
AlignedVector<T> maskOfFree(const Layout& layout, const Sheet& sheet) {
  AlignedVector<T> mask(static_cast<std::size_t>(layout.plane));
  for (int particle = 0; particle < sheet.count(); ++particle)
    mask[static_cast<std::size_t>(layout.at(particle))] = T(1);
  for (const int pin : sheet.pins) mask[static_cast<std::size_t>(layout.at(pin))] = T(0);
  return mask;
}

}  // namespace tyg

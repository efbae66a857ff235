// Ones and zeros by which the row kernels multiply what is not there, in place of branches.
// Must not know: forces.
#pragma once

#include <array>
#include <vector>

#include "core/forces/row_kernel.h"
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

/// How far to the right and down a mask's spring or cell reaches, in the order of the bits of Missing.
struct Reach {
  int right, down;
};
constexpr std::array<Reach, kMasks> kReaches{{{1, 0}, {0, 1}, {1, 1}, {1, 1}, {2, 0}, {0, 2}, {1, 1}}};

/// The masks of every row of which something is gone, as RowTask::there has them.
template <class T>
class RowMasks {
 public:
  RowMasks() = default;
  RowMasks(const Layout& layout, const Missing& missing) {
    if (missing.none()) return;
    ofRow_.resize(static_cast<std::size_t>(layout.rows));
    for (int row = 0; row < layout.rows; ++row) {
      if (!missing.anyIn(row * layout.columns, layout.columns)) continue;
      AlignedVector<T>& masks = ofRow_[static_cast<std::size_t>(row)];
      masks.assign(static_cast<std::size_t>(kMasks * layout.stride), T(0));
      for (int mask = 0; mask < kMasks; ++mask) {
        const auto [right, down] = kReaches.at(std::size_t(mask));
        if (row + down >= layout.rows) continue;
        for (int column = 0; column + right < layout.columns; ++column) {
          if (missing.has(row * layout.columns + column, Missing::Bit(1U << mask))) continue;
          masks[static_cast<std::size_t>(mask * layout.stride + column)] = T(1);
        }
      }
    }
  }
  /// Null: nothing of the row is gone.
  [[nodiscard]] const T* of(int row) const {
    if (ofRow_.empty() || ofRow_[static_cast<std::size_t>(row)].empty()) return nullptr;
    return ofRow_[static_cast<std::size_t>(row)].data();
  }

 private:
  std::vector<AlignedVector<T>> ofRow_;
};

}  // namespace tyg

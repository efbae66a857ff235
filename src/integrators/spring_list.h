// The springs as a list of pairs, for methods that visit or assemble them one by one. Explicit methods never do.
#pragma once

#include <vector>

#include "core/forces/state.h"
#include "tyg/sheet.h"

namespace tyg {

struct ListedSpring {
  std::ptrdiff_t first, second;  ///< slots in a plane
  double ks, kd, rest;           ///< N/m, N s/m, m
};

/// All springs of the families present: structural, then shear, then bend, each in index order.
std::vector<ListedSpring> listSprings(const Scene& scene, const Sheet& sheet);

/// Makes a list of the springs of `before`, on the same sheet, one of those of `now`. The pairs are listed anew only
/// where a family comes or goes.
void relistSprings(std::vector<ListedSpring>& springs, const Scene& before, const Scene& now, const Sheet& sheet);

}  // namespace tyg

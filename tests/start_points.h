// The start shape of a sheet as the viewer has it.
#pragma once

#include <vector>

#include "tyg/sheet.h"

namespace tyg {

/// x, y, z of every particle, m.
inline std::vector<float> startOf(const Sheet& sheet) {
  std::vector<float> xyz;
  for (int i = 0; i < sheet.count(); ++i) {
    const Vec3 p = sheet.startPosition(i);
    xyz.insert(xyz.end(), {float(p.x), float(p.y), float(p.z)});
  }
  return xyz;
}

}  // namespace tyg

// Which particles are moved against their neighbours: what an instability does first, as a number for each particle.
// Must not know: forces, drawing.
#pragma once

#include <span>

#include "tyg/sheet.h"

namespace tyg {

/// How far each particle is from the middle of its neighbours along the direction in which the farthest one is, as a
/// share of that one's distance, -1 to 1: neighbours that move against each other have opposite signs. All 0 where no
/// particle is away from that middle. `xyz` holds x, y, z of every particle, m; `values` one number for each.
void againstNeighbours(const Sheet& sheet, std::span<const float> xyz, std::span<float> values);

}  // namespace tyg

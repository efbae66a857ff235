// What hands have made of the cloth in its present run: cuts, and particles that were pinned or freed.
// Must not know: how it is done, who undoes it.
#pragma once

#include <vector>

#include "tyg/simulation.h"

namespace tyg {

/// A regular type: two runs with equal hand work have the same springs and pins.
struct HandWork {
  std::vector<CutLine> cuts;   ///< that are not taken back, in their order
  std::vector<PinEvent> pins;  ///< what is otherwise than at the start, by particle
  bool operator==(const HandWork&) const = default;
};

/// What a log comes to.
HandWork handWork(const EventLog& log);
/// Does what leads from one hand work to another: mends, cuts, pins and frees.
void applyHandWork(const HandWork& from, const HandWork& to, Simulation& simulation);

}  // namespace tyg

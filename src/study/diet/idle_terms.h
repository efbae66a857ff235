// The things that a scene models and that cannot be seen in its motion, told from the scene alone, without running it.
// Must not know: results, words of other reports.
#pragma once

#include <string>
#include <vector>

#include "tyg/scene.h"

namespace tyg {

/// One sentence for each thing that could be left out. Told are: everything, where nothing holds, moves or pushes a
/// sheet in free fall (its springs never stretch); families that have no springs on so narrow a sheet; damping of
/// particles and of springs that takes less than a thousandth of any velocity in the whole run; springs so weak that
/// pulled to twice their length they hold less than a thousandth of a particle's weight; pushes, winds, motions
/// of pins and displacements of no size, outside the run, on a pinned particle, or without air; air around a chain,
/// which has no cells; bodies that a sheet in free fall does not meet, and friction there or below a thousandth. What
/// costs more to find out, `tyg diet` measures.
std::vector<std::string> idleTerms(const Scene& scene);

}  // namespace tyg

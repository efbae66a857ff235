// Whether the steps of a run are short enough for the bodies that its cloth meets.
// Must not know: who says it.
#pragma once

#include <string>

#include "tyg/simulation.h"

namespace tyg {

/// How much of the layer of contact a step has crossed at the largest speed seen so far, as a fraction; 0 in scenes
/// without bodies.
double layersPerStep(const Simulation& simulation);

/// One sentence where equal steps are so long that contact is met roughly: where one crosses more than a third of the
/// layer. Else empty. A method that chooses its own steps is held by its tolerance.
std::string fastContactNote(const Simulation& simulation);

}  // namespace tyg

// Where a step of a method does not hold: the smallest single change of the sheet, or of the step, with which it does.
// Must not know: commands, measured limits, clocks.
#pragma once

#include <string>
#include <vector>

#include "tyg/method.h"
#include "tyg/scene.h"

namespace tyg {

/// Whether steps of dt (s) hold at rest: dt is no larger than restLatticeLimit(), or the method has no limit.
bool holdsAtRest(const Scene& scene, const Method& method, double dt);

/// Each of them alone makes a step hold. NaN where no such change does.
struct HoldingChanges {
  double dt = 0;         ///< s, the largest step that holds; 0 where none does
  double stiffness = 0;  ///< factor below 1 on the stiffness of all springs
  double damping = 0;    ///< N s/m of the structural springs, all others scaled with it; more or less than now
  double mass = 0;       ///< kg of each particle, more than now
};
/// The smallest changes, to 3 significant digits, on the side that holds, for a step that does not. Without any damping
/// it is looked for with one kd for all springs.
HoldingChanges changesThatHold(const Scene& scene, const Method& method, double dt);

/// The families of springs that set a limit at rest: without the damping of one of these, where damping sets it, else
/// without its stiffness, it would be another by more than 1 %.
std::vector<std::string> springsThatLimit(const Scene& scene, const Method& method, bool byDamping);

}  // namespace tyg

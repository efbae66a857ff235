// Power between the parts of a cloth, as the report's bond graph has them: sources (gravity, pushes) drive the masses,
// which exchange energy with the springs and lose it to the dampers. Must not know: how it is drawn, clocks.
#pragma once

#include "tyg/simulation.h"

namespace tyg {

/// W, on average over some time. Positive along the arrows of the graph.
struct PowerFlow {
  double gravity = 0;  ///< from gravity to the masses
  double pushes = 0;   ///< from pushes to the masses
  double springs = 0;  ///< from the masses to the springs
  double dampers = 0;  ///< from the masses to all that damps
  double kinetic = 0;  ///< what stays in the masses
  double missing = 0;  ///< what the method loses or makes up: the balance of all others
};
/// Between two ledgers of one run, `seconds` (> 0) apart, that follow the dissipation.
PowerFlow powerBetween(const Ledger& before, const Ledger& after, double seconds);

}  // namespace tyg

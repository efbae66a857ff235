// Power between the parts of a cloth, as the report's bond graph has them: sources (gravity, pushes) drive the masses,
// which exchange energy with the springs and lose it to the dampers. Must not know: how it is drawn, clocks.
#pragma once

#include "tyg/simulation.h"

namespace tyg {

/// W, averaged over about the last fifth of a simulated second. Positive along the arrows of the graph.
struct PowerFlow {
  double gravity = 0;  ///< from gravity to the masses
  double pushes = 0;   ///< from pushes to the masses
  double springs = 0;  ///< from the masses to the springs
  double dampers = 0;  ///< from the masses to damping and drag
  double kinetic = 0;  ///< what stays in the masses
  double missing = 0;  ///< what the method loses or makes up: the balance of all others
};

class PowerMeter {
 public:
  /// The ledger at a time (s); it must follow the dissipation. A time before the last one begins anew.
  void take(double time, const Ledger& ledger);
  void clear() {
    known_ = false;
    flow_ = {};
  }
  [[nodiscard]] const PowerFlow& flow() const { return flow_; }

 private:
  bool known_ = false;
  double time_ = 0;
  Ledger last_;
  PowerFlow flow_;
};

}  // namespace tyg

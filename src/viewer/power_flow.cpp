// Each power is the difference of one entry of two ledgers over the time between them.
#include "viewer/power_flow.h"

namespace tyg {

PowerFlow powerBetween(const Ledger& before, const Ledger& after, double seconds) {
  PowerFlow flow;
  flow.gravity = (before.gravitational - after.gravitational) / seconds;
  flow.pushes = (after.work - before.work) / seconds;
  flow.springs = (after.elastic - before.elastic) / seconds;
  flow.dampers = (after.dissipated - before.dissipated) / seconds;
  flow.kinetic = (after.kinetic - before.kinetic) / seconds;
  flow.missing = flow.gravity + flow.pushes - flow.springs - flow.dampers - flow.kinetic;
  return flow;
}

}  // namespace tyg

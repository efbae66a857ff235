// Each power is the difference of one entry of two ledgers over the time between them.
#include "viewer/power_flow.h"

#include "core/forces/term.h"

namespace tyg {

double PowerFlow::missing() const {
  double sum = -kinetic_;
  for (const Bond& source : sources()) sum += source.watts;
  for (const Bond& sink : sinks()) sum -= sink.watts;
  return sum;
}

PowerFlow powerBetween(const Ledger& before, const Ledger& after, double seconds) {
  PowerFlow flow;
  for (const EnergyStore& store : energyStores()) {
    if (!after.stored.has(store.name)) continue;
    const double watts = (after.stored[store.name] - before.stored[store.name]) / seconds;
    if (store.startsAtZero) {
      flow.addSource({store.holder, -watts});
    } else {
      flow.addSink({store.holder, watts});
    }
  }
  for (const Energies::Entry& work : after.work) {
    flow.addSource({work.name, (work.joules - before.work[work.name]) / seconds});
  }
  flow.addSink({"dampers", (after.dissipated - before.dissipated) / seconds});
  flow.setKinetic((after.kinetic - before.kinetic) / seconds);
  return flow;
}

}  // namespace tyg

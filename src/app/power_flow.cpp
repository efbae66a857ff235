// Differences of the ledger over time.
#include "app/power_flow.h"

#include <cmath>

namespace tyg {

void PowerMeter::take(double time, const Ledger& ledger) {
  constexpr double kMemory = 0.2;  // s: long enough to read, short enough to see a push
  if (known_ && time == time_) return;
  if (!known_ || time < time_) {
    flow_ = {};
  } else {
    const double seconds = time - time_, share = 1 - std::exp(-seconds / kMemory);
    const auto follow = [&](double& flow, double joules) { flow += share * (joules / seconds - flow); };
    const double gravity = last_.gravitational - ledger.gravitational, pushes = ledger.work - last_.work;
    const double springs = ledger.elastic - last_.elastic, dampers = ledger.dissipated - last_.dissipated;
    const double kinetic = ledger.kinetic - last_.kinetic;
    follow(flow_.gravity, gravity);
    follow(flow_.pushes, pushes);
    follow(flow_.springs, springs);
    follow(flow_.dampers, dampers);
    follow(flow_.kinetic, kinetic);
    follow(flow_.missing, gravity + pushes - springs - dampers - kinetic);
  }
  known_ = true;
  time_ = time;
  last_ = ledger;
}

}  // namespace tyg

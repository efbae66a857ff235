// What a simulation remembers besides what moves: time, pushes, energies, events. A copy of it is half of a checkpoint.
// Must not know: how anything of it comes about.
#pragma once

#include <cstdint>

#include "core/simulation/energy_watch.h"
#include "core/simulation/event_kinds.h"
#include "core/simulation/pin_motion.h"
#include "core/simulation/pushes.h"
#include "core/simulation/replay.h"
#include "core/simulation/sheet_changes.h"
#include "core/simulation/supply.h"
#include "core/simulation/tick_clock.h"
#include "tyg/method.h"

namespace tyg {

struct Run {
  /// `start`: the energies of the start shape. `followsLedger`: whether what is dissipated is followed from there.
  Run(const Scene& scene, const Sheet& sheet, const Method& startMethod, const StoredEnergy& start, bool followsLedger)
      : method(&startMethod),
        clock(scene.dt),
        pushes(scene, sheet),
        pins(scene, sheet),
        changes(scene, sheet),
        energies(scene, sheet, start, startMethod.order, followsLedger),
        log(beginLog(scene, startMethod.name)) {}

  const Method* method;
  TickClock clock;
  std::int64_t steps = 0;
  double largestStep = 0;   // s
  double largestSpeed = 0;  // m/s, see Simulation::largestSpeed
  Pushes pushes;
  PinMotion pins;
  SheetChanges changes;
  double cutAway = 0;     // J, that springs held when they were cut
  double ticksSince = 0;  // s: where the times begin at which cloth may tear, a tick apart
  Supply supply;          // of the ledger and of reports
  Supply judged;          // of the alarm, which judges alike whether or not the ledger is followed
  EnergyWatch energies;
  EventLog log;
  Replay replay;
};

}  // namespace tyg

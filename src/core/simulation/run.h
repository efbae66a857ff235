// What a simulation remembers besides what moves: time, pushes, alarm, log. A copy of it is half of a snapshot.
// Must not know: how anything of it comes about.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/simulation/alarm.h"
#include "core/simulation/pushes.h"
#include "tyg/method.h"
#include "tyg/push_log.h"

namespace tyg {

struct Run {
  /// `start`: the energies of the start shape. `followed`: is what is dissipated followed from there?
  Run(const Scene& scene, const Sheet& sheet, const Method& startMethod, const StoredEnergy& start, bool followed)
      : method(&startMethod),
        dt(scene.dt),
        pushes(scene, sheet),
        alarm(makeAlarm(scene, sheet, start)),
        startHeight(start.gravitational),
        startSum(start.kinetic + start.elastic),
        ledger(followed),
        log(beginLog(scene, startMethod.name)) {}

  const Method* method;
  double time = 0, dt, largestStep = 0;  // s
  std::int64_t ticks = 0, steps = 0;
  double tickBaseTime = 0;  // s; tick k begins at tickBaseTime + (k - tickBase) * dt
  std::int64_t tickBase = 0;

  Pushes pushes;
  Alarm alarm;
  Status status = Status::Ok;
  bool stuck = false;  // its steps have become too short to go on, alarm or not
  double alarmTime = std::numeric_limits<double>::quiet_NaN();
  double maxStretch = 0;
  double startHeight;  // J, gravitational energy of the start shape
  double startSum;     // J, of the ledger
  bool ledger;         // what is dissipated has been followed since then

  PushLog log;
  std::vector<LogEvent> script;  // of a replay, ascending ticks
  std::size_t scriptNext = 0;
};

}  // namespace tyg

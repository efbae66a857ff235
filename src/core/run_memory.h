// What a simulation remembers besides what moves: time, pushes, alarm, log. A copy of it is half of a snapshot.
// Must not know: how anything of it comes about.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/alarm.h"
#include "tyg/integrator.h"
#include "tyg/push_log.h"

namespace tyg {

/// A push of the scene, between two times, or one by hand, during whole ticks.
struct TimedPush {
  int particle = 0;
  Vec3 force;
  double begin = 0, end = 0;                ///< s, of the scene
  std::int64_t firstTick = 0, endTick = 0;  ///< by hand
  bool byHand = false;
  bool acting = false;
  Vec3 from;  ///< where the particle was when the push began to act
};

/// Everything that a run remembers besides what moves: a regular type, so that a snapshot is a copy.
struct Run {
  explicit Run(const Alarm& quietAlarm) : alarm(quietAlarm) {}

  const Method* method = nullptr;
  double time = 0, dt = 0, largestStep = 0;  // s
  std::int64_t ticks = 0, steps = 0;
  double tickBaseTime = 0;  // s; tick k begins at tickBaseTime + (k - tickBase) * dt
  std::int64_t tickBase = 0;

  std::vector<TimedPush> pushes;
  double finishedWork = 0;  // J, of pushes that have ended

  Alarm alarm;
  Status status = Status::Ok;
  bool stuck = false;  // its steps have become too short to go on, alarm or not
  double alarmTime = std::numeric_limits<double>::quiet_NaN();
  double maxStretch = 0;
  double startHeight = 0;  // J, gravitational energy of the start shape
  double startSum = 0;     // J, of the ledger
  bool ledger = false;     // what is dissipated has been followed since then

  PushLog log;
  std::vector<LogEvent> script;  // of a replay, ascending ticks
  std::size_t scriptNext = 0;
};

}  // namespace tyg

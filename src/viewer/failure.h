// How a run failed: what the person is told, and the ways out.
// Must not know: how a failure is noticed, how a cure is taken.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "viewer/cure.h"

namespace tyg {

struct Failure {
  /// The last state that was shown before the alarm.
  struct LastGood {
    std::int64_t tick = 0;
    double time = 0;  ///< s
  };
  std::string message;               ///< why the cloth is frozen; empty: it is not
  std::optional<Cure> cure;          ///< nothing where the cloth did not freeze by its alarm
  std::optional<LastGood> lastGood;  ///< nothing while no alarm has stopped the run
  bool runsOn = false;               ///< the person let the run go on past its alarm
};

}  // namespace tyg

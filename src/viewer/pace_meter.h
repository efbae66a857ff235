// How fast frames follow each other, and how much of their time the simulation takes, smoothed over half a second.
// Must not know: clocks (times are arguments), the simulation, windows.
#pragma once

#include "view/frame_clock.h"

namespace tyg {

/// How the last half second went.
struct Pace {
  double framesPerSecond = 0;  ///< 0 before anything moved
  double simulating = 0;       ///< share of the frame spent simulating, 0..1
  double realTime = 1;         ///< simulated seconds per second
  bool behind = false;         ///< the machine did not keep up with the wanted speed
  enum class Slow { Nothing, Drawing, Simulating };
  Slow slow = Slow::Nothing;  ///< what most of the time went into, where frames came late or time fell behind
};

class PaceMeter {
 public:
  /// A frame came `frameSeconds` after the last one, and `simulatingSeconds` of it went into simulating. A frame after
  /// a long rest tells nothing and is left out.
  void measure(double frameSeconds, double simulatingSeconds, const FrameClock& clock);
  [[nodiscard]] const Pace& pace() const { return pace_; }
  /// s of a frame that everything but the simulation takes.
  [[nodiscard]] double otherSeconds() const { return frameSeconds_ - simulatingSeconds_; }

 private:
  Pace pace_;
  double frameSeconds_ = 0, simulatingSeconds_ = 0;  ///< smoothed
  bool late_ = false;                                ///< frames come late
};

}  // namespace tyg

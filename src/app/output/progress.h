// A line on the terminal that says how far long work is and how long it will still take.
// Must not know: what the work is.
#pragma once

#include <chrono>
#include <string>

namespace tyg {

/// Shows on standard error, only where that is a terminal and only once the work has taken half a second. The line is
/// wiped when the work is finished or this object goes.
class Progress {
 public:
  /// `what` is a few words in front of the percentage.
  explicit Progress(std::string what);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `fraction` of the work done, in [0, 1]. Cheap: draws ten times a second at most.
  void show(double fraction);
  /// Wipes the line, so that a message can follow.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  std::string what_;
  bool terminal_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now(), nextDraw_;
};

/// A length of time for people: `8 s`, `3 min 20 s`, `2 h 5 min`.
std::string readableTime(double seconds);

}  // namespace tyg

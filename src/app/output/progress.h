// What is said of long work: how much it will write, a line on the terminal with the time that it will still take, and
// that it was interrupted.
// Must not know: what the work is.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <string_view>

#include "tyg/scene.h"

namespace tyg {

/// Shows on standard error, only where that is a terminal and only once the work has taken half a second. The line is
/// wiped when the work is finished or this object goes.
class Progress {
 public:
  /// `what` is a few words in front of the percentage.
  explicit Progress(std::string_view what);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `fraction` of the work done, in [0, 1]. Cheap: draws ten times a second at most. Returns false after an interrupt:
  /// the work is then to be stopped.
  bool show(double fraction);
  /// An observer of a part of the work, which takes it from one fraction of the whole to another. It calls show().
  std::function<bool(double)> part(double from = 0, double to = 1);
  /// Wipes the line, so that a message can follow.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  void draw(double fraction);

  std::string what_;
  bool terminal_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now(), nextDraw_;
};

/// Says on standard error about how much `command` will write to `out` where that is a gigabyte or more: numbers of all
/// particles at so many times, each of which takes so many bytes.
void sayLargeOutput(const std::string& command, const std::string& out, const Scene& scene, std::size_t times,
                    double bytes);

/// Says on standard error that `command` was interrupted and what is `kept`; returns the exit code for that.
int sayInterrupted(const std::string& command, const std::string& kept = "nothing was written");

/// A length of time for people: `8 s`, `3 min 20 s`, `2 h 5 min`.
std::string readableTime(double seconds);

}  // namespace tyg

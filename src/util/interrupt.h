// Ctrl-C as a flag that long work asks for, so that nothing is left half done.
// Must not know: what is interrupted.
#pragma once

namespace tyg {

/// While one of these lives, the first Ctrl-C (or SIGTERM) only raises the flag. A second one ends the program at once,
/// as sudden_end.h says, and so does the first where nobody has asked interrupted() in time: some work cannot ask. A
/// terminal that is closed (SIGHUP) raises the flag too, however often it is told.
/// Signals that the program was started with as ignored stay ignored.
class InterruptWatch {
 public:
  /// Within a second, whatever is under way.
  static constexpr double kPatience = 0.7;
  /// `patience`: s that the first signal waits for somebody to ask, > 0.
  explicit InterruptWatch(double patience = kPatience);
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;
};

/// Was there an interrupt since the newest watch began?
bool interrupted();

}  // namespace tyg

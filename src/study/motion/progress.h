// How far a study is: what its observer is told, and whether the observer has said stop.
// Must not know: what is studied, clocks.
#pragma once

#include <algorithm>
#include <functional>
#include <utility>

namespace tyg {

class Progress {
 public:
  /// `observer` gets the fraction of the work that is done and may return false to stop; it may be empty.
  explicit Progress(std::function<bool(double fraction)> observer) : observer_(std::move(observer)) {}

  /// Tells the observer that this fraction is done, never less than it was told before; false: stop.
  bool reach(double fraction) {
    fraction_ = std::max(fraction_, fraction);
    stopped_ = stopped_ || (observer_ && !observer_(fraction_));
    return !stopped_;
  }
  /// Moves on without telling.
  void advanceTo(double fraction) { fraction_ = std::max(fraction_, fraction); }
  /// Asks the observer again where nothing more is done.
  bool goesOn() { return reach(fraction_); }

  [[nodiscard]] double fraction() const { return fraction_; }
  [[nodiscard]] bool stopped() const { return stopped_; }

 private:
  std::function<bool(double)> observer_;
  double fraction_ = 0;
  bool stopped_ = false;
};

}  // namespace tyg

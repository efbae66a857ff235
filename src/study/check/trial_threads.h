// Pieces of work that do not depend on each other, shared out among threads, and the sign to stop them all.
// Must not know: what the work is.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>

#include "util/workers.h"

namespace tyg {

class TrialThreads {
 public:
  /// `threads` >= 1, the calling one included. `observer` gets the fraction done, on that thread alone; false: stop.
  /// May be empty.
  TrialThreads(int threads, std::function<bool(double)> observer);

  /// Calls `work(k)` for each k below `count`, begun in that order, and returns when all are done. Throws what one of
  /// them throws.
  void forEach(std::size_t count, const std::function<void(std::size_t)>& work);

  /// To be asked now and then by any thread at work: false where all is to stop.
  bool goesOn();
  /// What is to be told from now on.
  void reach(double fraction) { fraction_ = fraction; }
  [[nodiscard]] bool stopped() const { return stopped_; }
  [[nodiscard]] int threads() const { return workers_.threads(); }

 private:
  Workers workers_;
  std::function<bool(double)> observer_;
  std::thread::id owner_ = std::this_thread::get_id();
  std::atomic<double> fraction_{0};
  std::atomic<bool> stopped_{false};
};

}  // namespace tyg

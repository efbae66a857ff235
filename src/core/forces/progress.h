// How threads that work on the rows of a sheet one behind another wait for each other. Must not know: what they do.
#pragma once

#include <atomic>
#include <thread>

namespace tyg {

/// How far a group of steps has come, alone on its cache line.
struct alignas(64) Progress {
  std::atomic<int> rows{0};

  /// Another thread works on it right now: spinning is short, and gives way where threads share cores.
  void await(int wanted) const {
    for (int spin = 0; rows.load(std::memory_order_acquire) < wanted; ++spin) {
      if (spin > 1000) std::this_thread::yield();
    }
  }
};

}  // namespace tyg

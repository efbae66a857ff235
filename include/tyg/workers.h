// A few threads that share out the rows of a sheet. With one thread it is a plain call.
#pragma once

#include <functional>
#include <memory>

namespace tyg {

/// Threads that wait for work without spinning for long, so that idle workers do not slow the others down.
class Workers {
 public:
  /// `threads` >= 1, the calling one included.
  explicit Workers(int threads);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  [[nodiscard]] int threads() const { return threads_; }
  /// Calls `work(first, last, thread)` for contiguous bands that together cover [0, rows), and returns when all are done.
  void forBands(int rows, const std::function<void(int first, int last, int thread)>& work);

 private:
  struct Pool;
  int threads_;
  std::unique_ptr<Pool> pool_;
};

/// Threads to use where nobody asked: 1 below the size where a second one pays, else every core.
int defaultThreads(int particles);

}  // namespace tyg

// A few threads that share out the rows of a sheet. With one thread it is a plain call.
#pragma once

#include <memory>

namespace tyg {

/// Threads that wait for work without spinning for long, so that idle workers do not slow the others down.
class Workers {
 public:
  /// `threads` >= 1, the calling one included. Where the system gives fewer, there are fewer: see threads().
  explicit Workers(int threads);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  [[nodiscard]] int threads() const { return threads_; }

  /// Calls `work(first, last, thread)` for contiguous bands that together cover [0, rows), thread by thread, and
  /// returns when all are done. Allocates nothing.
  template <class Work>
  void forBands(int rows, const Work& work) {
    if (threads_ == 1) {
      work(0, rows, 0);
    } else {
      share({rows, &work, [](const void* w, int first, int last, int thread) {
               (*static_cast<const Work*>(w))(first, last, thread);
             }});
    }
  }

 private:
  struct Job {
    int rows = 0;
    const void* work = nullptr;
    void (*call)(const void* work, int first, int last, int thread) = nullptr;
  };
  struct Pool;
  void share(const Job& job);

  int threads_ = 1;
  std::unique_ptr<Pool> pool_;
};

/// Threads to use where nobody asked: 1 below the size where a second one pays, else every core.
int defaultThreads(int particles);

}  // namespace tyg

// One thread of the lowest priority for work beside a running window: one job at a time, of which only the newest
// counts. Must not know: what a job does, how its results are handed over.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>

namespace tyg {

class BackgroundThread {
 public:
  /// False once another job, or none, is wanted. A job asks it as often as it can, and then ends.
  using GoesOn = std::function<bool()>;
  using Job = std::function<void(const GoesOn&)>;  ///< throws nothing

  BackgroundThread() = default;
  /// Stops, and waits until the job notices it.
  ~BackgroundThread();
  BackgroundThread(const BackgroundThread&) = delete;
  BackgroundThread& operator=(const BackgroundThread&) = delete;

  /// Begins this job in the place of any other. Returns at once.
  void start(Job job);
  /// Nothing is wanted any more. Returns at once.
  void stop();
  /// The nice value of the thread, 19 where the system lets it be; 0 before it runs.
  [[nodiscard]] int niceness() const { return niceness_; }

 private:
  void serve();

  std::atomic<std::uint64_t> wanted_{0};  ///< number of the job to be done
  std::atomic<int> niceness_{0};
  std::mutex mutex_;  ///< guards what is declared below it; held for very short times
  std::condition_variable woken_;
  Job next_;
  std::uint64_t nextNumber_ = 0;
  bool ending_ = false;
  std::thread thread_;  ///< started by the first start()
};

}  // namespace tyg

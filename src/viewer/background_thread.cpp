// A job that is not wanted any more finds its number out of date.
#include "viewer/background_thread.h"

#include <utility>

#include "util/thread_priority.h"

namespace tyg {

BackgroundThread::~BackgroundThread() {
  if (!thread_.joinable()) return;
  {
    const std::scoped_lock lock(mutex_);
    ++wanted_;
    ending_ = true;
  }
  woken_.notify_one();
  thread_.join();
}

void BackgroundThread::start(Job job) {
  {
    const std::scoped_lock lock(mutex_);
    nextNumber_ = ++wanted_;
    next_ = std::move(job);
  }
  if (!thread_.joinable()) thread_ = std::thread([this] { serve(); });
  woken_.notify_one();
}

void BackgroundThread::stop() {
  const std::scoped_lock lock(mutex_);
  ++wanted_;
  next_ = nullptr;
}

void BackgroundThread::serve() {
  niceness_ = lowerThreadPriority();
  while (true) {
    Job job;
    std::uint64_t number = 0;
    {
      std::unique_lock lock(mutex_);
      woken_.wait(lock, [this] { return ending_ || next_; });
      if (ending_) return;
      job = std::exchange(next_, nullptr);
      number = nextNumber_;
    }
    job([this, number] { return wanted_.load(std::memory_order_relaxed) == number; });
  }
}

}  // namespace tyg

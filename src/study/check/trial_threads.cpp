// Each thread takes the next piece when it is done with one: pieces differ much in what they cost.
#include "study/check/trial_threads.h"

#include <exception>
#include <mutex>
#include <utility>

namespace tyg {

TrialThreads::TrialThreads(int threads, std::function<bool(double)> observer)
    : workers_(threads), observer_(std::move(observer)) {}

void TrialThreads::forEach(std::size_t count, const std::function<void(std::size_t)>& work) {
  if (count <= 1) {  // not worth a second thread's attention
    if (count == 1) work(0);
    return;
  }
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr trouble;
  workers_.forBands(workers_.threads(), [&](int /*first*/, int /*last*/, int /*thread*/) {
    try {
      for (std::size_t k = next++; k < count; k = next++) work(k);
    } catch (...) {
      const std::scoped_lock lock(mutex);
      trouble = std::current_exception();
      next = count;
    }
  });
  if (trouble) std::rethrow_exception(trouble);
}

bool TrialThreads::goesOn() {
  if (observer_ && std::this_thread::get_id() == owner_ && !observer_(fraction_)) stopped_ = true;
  return !stopped_;
}

}  // namespace tyg

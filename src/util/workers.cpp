// Bands of rows on threads: one generation counter starts a job, one counter of finished bands ends it.
#include "util/workers.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>
#include <system_error>
#include <thread>
#include <vector>

#include "util/sleeping.h"

namespace tyg {
namespace {

// Long enough to bridge the serial code between two evaluations, short enough to cost an idle machine nothing.
constexpr int kSpins = 2000;
constexpr std::size_t kLeftForWork = 64 << 20;  // bytes of addresses that threads do not get

void pauseBriefly() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

/// Returns once `number` differs from `old`.
void awaitChange(const std::atomic<unsigned>& number, unsigned old, int spins) {
  for (int spin = 0; spin < spins; ++spin) {
    if (number.load(std::memory_order_acquire) != old) return;
    pauseBriefly();
  }
  sleepWhile(number, old);
}

}  // namespace

struct Workers::Pool {
  Job job;
  std::atomic<unsigned> generation{0};
  std::atomic<unsigned> unfinished{0};
  std::atomic<bool> ending{false};
  int bands = 1;  // of a job, one for every thread; set before the first job
  int spins = 0;  // none where threads share cores: a spinning one would only keep a working one waiting
  // Held while threads are made, and never written to: their stacks could else leave no memory for the work itself.
  std::unique_ptr<std::byte[]> leftForWork;
  std::vector<std::jthread> threads;

  ~Pool() {
    ending = true;
    ++generation;
    wakeSleepers(generation);
  }

  void doBand(int thread) const {
    const auto edge = [&](int k) { return int(static_cast<long long>(job.rows) * k / bands); };
    job.call(job.work, edge(thread), edge(thread + 1), thread);
  }

  void serve(int thread) {
    unsigned seen = 0;
    while (true) {
      awaitChange(generation, seen, spins);
      ++seen;
      if (ending.load(std::memory_order_relaxed)) return;
      doBand(thread);
      if (unfinished.fetch_sub(1, std::memory_order_acq_rel) == 1) wakeSleepers(unfinished);
    }
  }
};

Workers::Workers(int threads) {
  if (threads <= 1) return;
  pool_ = std::make_unique<Pool>();
  pool_->leftForWork = std::make_unique_for_overwrite<std::byte[]>(kLeftForWork);
  pool_->spins = threads <= int(std::thread::hardware_concurrency()) ? kSpins : 0;
  try {
    for (; threads_ < threads; ++threads_) {
      pool_->threads.emplace_back([pool = pool_.get(), k = threads_] { pool->serve(k); });
    }
  } catch (const std::system_error&) {
    // The system gives no more: those that there are do the same work, to the same bits.
  }
  pool_->leftForWork.reset();
  pool_->bands = threads_;
}

Workers::~Workers() = default;

void Workers::share(const Job& job) {
  pool_->job = job;
  pool_->unfinished.store(unsigned(threads_ - 1), std::memory_order_relaxed);
  pool_->generation.fetch_add(1, std::memory_order_release);
  wakeSleepers(pool_->generation);
  pool_->doBand(0);
  for (unsigned left = pool_->unfinished.load(std::memory_order_acquire); left > 0;
       left = pool_->unfinished.load(std::memory_order_acquire)) {
    awaitChange(pool_->unfinished, left, pool_->spins);
  }
}

int defaultThreads(int particles) {
  constexpr int kWorthASecondThread = 128 * 128;
  if (particles < kWorthASecondThread) return 1;
  return std::max(1, int(std::thread::hardware_concurrency()));
}

}  // namespace tyg

// Work shared out over threads: every row is done once, whatever the number of threads.
#include "util/workers.h"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

namespace tyg {
namespace {

TEST(Workers, DoEveryRowOnceWhateverTheNumberOfThreads) {
  for (int threads = 1; threads <= 5; ++threads) {
    Workers workers(threads);
    for (const int rows : {0, 1, 3, 5, 64, 1001}) {
      std::vector<int> done(std::size_t(rows), 0);  // bands do not overlap, so that no two threads write to one row
      workers.forBands(rows, [&](int first, int last, int) {
        for (int row = first; row < last; ++row) ++done[std::size_t(row)];
      });
      EXPECT_EQ(done, std::vector<int>(std::size_t(rows), 1)) << rows << " rows, " << threads << " threads";
    }
  }
}

TEST(Workers, GiveEachThreadOneBandUnderANumberOfItsOwn) {
  Workers workers(4);
  std::vector<std::atomic<int>> bands(std::size_t(workers.threads()));
  workers.forBands(100, [&](int, int, int thread) { ++bands.at(std::size_t(thread)); });
  for (const std::atomic<int>& count : bands) EXPECT_EQ(count, 1);
}

TEST(Workers, FinishOneJobBeforeTheNextBegins) {
  constexpr int kJobs = 2000, kRows = 7;
  Workers workers(3);
  std::vector<int> sums(kRows, 0);
  for (int job = 1; job <= kJobs; ++job) {
    // Each row is taken from the one that another thread may have written in the job before.
    const std::vector<int> before = sums;
    workers.forBands(kRows, [&](int first, int last, int) {
      for (int row = first; row < last; ++row) sums[std::size_t(row)] = before[std::size_t((row + 3) % kRows)] + 1;
    });
  }
  EXPECT_EQ(sums, std::vector<int>(kRows, kJobs));
}

TEST(Workers, AreOneForASmallSheet) {
  EXPECT_EQ(defaultThreads(400), 1);
  EXPECT_GE(defaultThreads(1000000), 1);
}

}  // namespace
}  // namespace tyg

// The study of speed against accuracy of a scene, made on a thread of its own while the window goes on: one thread, at
// the lowest priority, that hands over its rows as they come. Must not know: windows, panels, how rows are shown.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "study/motion/reference.h"
#include "study/work/work_rows.h"

namespace tyg {

/// What a background study knows so far.
struct StudyProgress {
  enum class Stage { Idle, Reference, Rows, Done, Failed };
  Stage stage = Stage::Idle;
  double fraction = 0;                         ///< done of the whole, 0..1
  std::vector<WorkRow> rows;                   ///< method by method, coarse to fine; of the scene's precision
  bool allMethods = false;                     ///< each has had its first rows, or none to give
  std::vector<std::string> refusals;           ///< why a method is not in the rows
  std::string problem;                         ///< Failed: why, for the person
  std::shared_ptr<const Reference> reference;  ///< from Rows on
};

class BackgroundStudy {
 public:
  /// Larger sheets are not studied beside a running window: one of their runs would take many seconds.
  static constexpr int kMostParticles = 64 * 64;

  using Clock = std::function<double()>;  ///< s, from any start

  /// What a method costs is measured by this clock on the study's own thread: it should count what that thread has
  /// computed, so that other programs do not matter.
  explicit BackgroundStudy(Clock clock) : clock_(std::move(clock)) {}
  /// Stops, and waits until the thread notices it: some steps of one run.
  ~BackgroundStudy();
  BackgroundStudy(const BackgroundStudy&) = delete;
  BackgroundStudy& operator=(const BackgroundStudy&) = delete;

  /// Begins the study of this scene in its own precision, in the place of any other: first some coarse rows of each of
  /// these methods, then the rest of one after the other. Returns at once.
  void start(const Scene& scene, std::vector<const Method*> methods);
  /// Ends the study and forgets what it found. Returns at once.
  void stop();
  /// What is known by now. Never waits: where the thread is just handing something over it is what was known before.
  /// Valid until the next call. For the thread that called start().
  const StudyProgress& progress();
  /// True until everything found has been seen by progress().
  [[nodiscard]] bool running() const;
  /// The nice value of the thread, 19 where the system lets it be; 0 before the first start.
  [[nodiscard]] int niceness() const { return niceness_; }

 private:
  struct Job {
    Scene scene;
    std::vector<const Method*> methods;
    std::uint64_t number = 0;
  };
  void replaceJob(std::optional<Job> job);
  void serve();
  void study(const Job& job);
  void rowsOf(const Job& job, const std::shared_ptr<const Reference>& reference);
  [[nodiscard]] bool goesOn(const Job& job) const { return wanted_.load(std::memory_order_relaxed) == job.number; }
  bool report(const Job& job, double fraction);
  template <class Change>
  void tell(const Job& job, const Change& change);

  Clock clock_;
  std::atomic<std::uint64_t> wanted_{0};  ///< number of the job to be done; others stop when they see it
  std::atomic<double> fraction_{0};
  std::atomic<int> niceness_{0};

  std::mutex mutex_;  ///< guards what is declared below it; held for very short times
  std::condition_variable woken_;
  std::optional<Job> next_;
  bool ending_ = false;
  StudyProgress told_;
  std::uint64_t changes_ = 0;  ///< of told_

  StudyProgress seen_;  ///< by the owner's thread alone, as seenChanges_
  std::uint64_t seenChanges_ = 0;
  std::thread thread_;  ///< started by the first start()
};

}  // namespace tyg

// The study of speed against accuracy of a scene, made on a thread of its own while the window goes on: one thread, at
// the lowest priority, that hands over its rows as they come. Must not know: windows, panels, how rows are shown.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "study/motion/reference.h"
#include "study/work/work_rows.h"
#include "viewer/background_thread.h"

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
  [[nodiscard]] int niceness() const { return thread_.niceness(); }

 private:
  struct Job {
    Scene scene;
    std::vector<const Method*> methods;
    BackgroundThread::GoesOn goesOn;
  };
  void forget(StudyProgress::Stage stage);
  void study(const Job& job);
  void rowsOf(const Job& job, const std::shared_ptr<const Reference>& reference);
  bool report(const Job& job, double fraction);
  template <class Change>
  void tell(const Job& job, const Change& change);

  Clock clock_;
  std::atomic<double> fraction_{0};

  std::mutex mutex_;  ///< guards the two below it; held for very short times
  StudyProgress told_;
  std::uint64_t changes_ = 0;  ///< of told_

  StudyProgress seen_;  ///< by the owner's thread alone, as seenChanges_
  std::uint64_t seenChanges_ = 0;
  BackgroundThread thread_;  ///< last, so that it ends first
};

}  // namespace tyg

// The check of a motion that another program wrote, made beside the running window.
// Must not know: windows, panels, how a motion is checked.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <string>

#include "study/check/motion_check.h"
#include "viewer/background_thread.h"

namespace tyg {

/// What is known of a motion by now.
struct CheckProgress {
  enum class Stage { Idle, Running, Stopped, Done, Failed };
  Stage stage = Stage::Idle;
  double fraction = 0;  ///< done of the whole, 0..1
  bool good = false;    ///< Done: the motion is right, and its step is not too long
  std::string words{};  ///< Done: the sentences about it. Failed: why there are none
};

class BackgroundCheck {
 public:
  /// Begins the check of this motion of the scene, in the place of any other, on one thread. Returns at once.
  void start(const Scene& scene, std::shared_ptr<const GivenMotion> motion);
  /// Ends a check that is running. Returns at once.
  void stop();
  /// Forgets what was found.
  void clear();
  /// What is known by now. Never waits. Valid until the next call. For the thread that called start().
  const CheckProgress& progress();

 private:
  void begin(CheckProgress::Stage stage);
  void tell(const BackgroundThread::GoesOn& goesOn, CheckProgress told);

  std::atomic<double> fraction_{0};
  std::mutex mutex_;  ///< guards told_; held for very short times
  CheckProgress told_;
  CheckProgress seen_;       ///< by the owner's thread alone
  BackgroundThread thread_;  ///< last, so that it ends first
};

}  // namespace tyg

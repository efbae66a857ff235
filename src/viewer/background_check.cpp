// What the check found is handed over once, when it is done.
#include "viewer/background_check.h"

#include <exception>
#include <utility>

namespace tyg {
namespace {

using Stage = CheckProgress::Stage;

CheckProgress found(const MotionCheck& check) {
  std::string words = verdictWords(check);
  if (!check.tears.empty()) words.append(" ").append(check.tears);
  using enum MotionCheck::Verdict;
  const bool isRight = check.verdict == Right || check.verdict == OtherMethod;
  return {.stage = Stage::Done, .fraction = 1, .good = isRight && !check.stepIsTooLong(), .words = words};
}

}  // namespace

void BackgroundCheck::start(const Scene& scene, std::shared_ptr<const GivenMotion> motion) {
  thread_.stop();
  begin(Stage::Running);
  thread_.start([this, scene, motion = std::move(motion)](const BackgroundThread::GoesOn& goesOn) {
    const auto observer = [&](double fraction) {
      if (goesOn()) fraction_ = fraction;
      return goesOn();
    };
    try {
      tell(goesOn, found(checkMotion(scene, *motion, {.dt = {}, .threads = 1, .observer = observer})));
    } catch (const std::exception& error) {
      tell(goesOn, {.stage = Stage::Failed, .words = error.what()});
    }
  });
}

void BackgroundCheck::stop() {
  thread_.stop();
  if (progress().stage == Stage::Running) begin(Stage::Stopped);
}

void BackgroundCheck::clear() {
  thread_.stop();
  begin(Stage::Idle);
}

void BackgroundCheck::begin(Stage stage) {
  const std::scoped_lock lock(mutex_);
  fraction_ = 0;
  seen_ = told_ = {.stage = stage};
}

/// What a check that is not wanted any more has found is not taken.
void BackgroundCheck::tell(const BackgroundThread::GoesOn& goesOn, CheckProgress told) {
  const std::scoped_lock lock(mutex_);
  if (goesOn()) told_ = std::move(told);
}

const CheckProgress& BackgroundCheck::progress() {
  if (seen_.stage != Stage::Running) return seen_;
  seen_.fraction = fraction_;
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (lock.owns_lock() && told_.stage != Stage::Running) seen_ = told_;
  return seen_;
}

}  // namespace tyg

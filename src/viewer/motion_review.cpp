// The scene that a motion was checked against is kept: whoever changes the cloth is told that the verdict is of
// another.
#include "viewer/motion_review.h"

#include <filesystem>
#include <utility>

#include "study/check/motion_fit.h"
#include "util/visible_text.h"

namespace tyg {
namespace {

/// The scene without what a check tries out by itself.
Scene checkedPart(Scene scene) {
  scene.title.clear(), scene.shows.clear(), scene.lamps.clear(), scene.integrator.clear();
  scene.dt = scene.tolerance = scene.duration = 1;
  scene.precision = Precision::Double;
  scene.look = {};
  return scene;
}

}  // namespace

void MotionReview::open(const std::string& text, const std::string& path, const Scene& scene) {
  motion_ = std::make_shared<const GivenMotion>(readMotion(text, path, scene));
  ghost_.emplace(motion_, scene);
  name_ = oneLine(std::filesystem::path(path).filename().string());
  ++opened_;
  checkAgain(scene);
}

void MotionReview::checkAgain(const Scene& scene) {
  checked_ = scene;
  check_.start(scene, motion_);
}

std::string MotionReview::beginRun(const Scene& scene) {
  if (!ghost_) return "";
  try {
    refuseOtherMotion(*motion_, scene, name_);
    ghost_.emplace(motion_, scene);  // its pins may be others
    return "";
  } catch (const InputError& error) {
    ghost_.reset();
    motion_.reset();
    check_.clear();
    return std::string("The motion is closed: ") + error.what();
  }
}

bool MotionReview::isOf(const Scene& scene) const { return checkedPart(scene) == checkedPart(checked_); }

}  // namespace tyg

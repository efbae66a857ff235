// A viewer in a window that is not there, with a clock that the test moves.
#pragma once

#include <gtest/gtest.h>

#include "tyg/methods.h"
#include "viewer/viewer.h"

namespace tyg {

using Kind = WindowEvent::Kind;

class ViewerTest : public testing::Test {
 protected:
  static Scene curtain() { return loadScene("curtain", methodNames()); }

  explicit ViewerTest(const Scene& scene = curtain())
      : viewer_(scene, Settings{.threads = 1}, [this] { return now_ += look_; }) {
    viewer_.resize({.width = 1280, .height = 720}, {.left = 200, .right = 200});
  }
  void press(KeyCode key, double x = 0, double y = 0) {
    viewer_.handle({.kind = Kind::Press, .key = key, .x = x, .y = y});
  }
  void release(KeyCode key) { viewer_.handle({.kind = Kind::Release, .key = key}); }
  void tap(KeyCode key) { press(key), release(key); }
  void frames(int count, double seconds = 1.0 / 60) {
    for (int frame = 0; frame < count; ++frame) {
      now_ += seconds;
      viewer_.frame();
    }
  }
  /// A click on the middle of the cloth as it is seen now.
  void clickOnCloth() {
    const auto xyz = viewer_.run().shown().positions();
    const std::size_t middle = 3 * 210;  // column 10, row 10 of the 20 x 20 curtain
    const glm::vec4 clip = viewer_.view().camera().projection(1280.0F / 720) * viewer_.view().camera().view() *
                           glm::vec4(xyz[middle], xyz[middle + 1], xyz[middle + 2], 1);
    press(kLeftButton, 640 * (1 + double(clip.x / clip.w)), 360 * (1 - double(clip.y / clip.w)));
  }
  [[nodiscard]] std::int64_t ticks() const { return viewer_.run().simulation().ticks(); }

  double now_ = 100;
  double look_ = 0;  ///< s that each look at the clock takes
  Viewer viewer_;
};

}  // namespace tyg

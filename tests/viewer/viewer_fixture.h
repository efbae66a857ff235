// A viewer in a window that is not there, with a clock that the test moves.
#pragma once

#include <gtest/gtest.h>

#include "tyg/methods.h"
#include "view/picking.h"
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
  /// Where a particle is seen now, in pixels.
  [[nodiscard]] glm::dvec2 placeOf(int particle) const {
    const auto xyz = viewer_.run().shown().positions().subspan(3 * static_cast<std::size_t>(particle), 3);
    return placeInWindow(viewer_.view().camera(), {xyz[0], xyz[1], xyz[2]}, {1280, 720});
  }
  void pressAt(glm::dvec2 place) { press(kLeftButton, place.x, place.y); }
  void moveTo(glm::dvec2 place) { viewer_.handle({.kind = Kind::Move, .x = place.x, .y = place.y}); }
  /// A press on the middle of the cloth as it is seen now: column 10, row 10 of the 20 x 20 curtain.
  void pressOnCloth() { pressAt(placeOf(210)); }
  void clickOnCloth() { pressOnCloth(), release(kLeftButton); }
  [[nodiscard]] std::int64_t ticks() const { return viewer_.run().simulation().ticks(); }

  double now_ = 100;
  double look_ = 0;  ///< s that each look at the clock takes
  Viewer viewer_;
};

}  // namespace tyg

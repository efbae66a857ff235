// Grabbing, pinning and cutting with the left button, without a window, and taking it back.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "viewer/edits.h"
#include "viewer/tools.h"
#include "viewer/viewer_fixture.h"

namespace tyg {
namespace {

constexpr KeyCode kHand = functionKey(2), kPin = functionKey(3), kCut = functionKey(4);

template <class Kind>
int countOf(const EventLog& log) {
  return int(std::ranges::count_if(log.events, [](const Event& e) { return std::holds_alternative<Kind>(e.action); }));
}

class HandToolsTest : public ViewerTest {
 protected:
  void grabMiddle(glm::dvec2 way) {
    const glm::dvec2 from = placeOf(210);
    pressAt(from), moveTo(from + way);
  }
  void drag(glm::dvec2 from, glm::dvec2 to) { pressAt(from), moveTo(to), release(kLeftButton); }
  /// Across the whole cloth between two rows, from outside to outside.
  void cutBelowRow(int row) {
    tap(kCut);
    const glm::dvec2 left = (placeOf(20 * row) + placeOf(20 * row + 20)) / 2.0;
    const glm::dvec2 right = (placeOf(20 * row + 19) + placeOf(20 * row + 39)) / 2.0;
    drag(left - 0.1 * (right - left), right + 0.1 * (right - left));
  }
  void expectReplays() {
    const EventLog log = viewer_.run().record();
    Simulation again(curtain(), findMethod(log.integrator), {.threads = 1});
    again.replay(parseEventLog(formatEventLog(log), "log"), methods());
    again.tick(log.ticks);
    EXPECT_EQ(hashText(again), log.hash);
  }
  [[nodiscard]] const Sheet& sheet() const { return viewer_.run().simulation().sheet(); }
  [[nodiscard]] bool pinned(int particle) const { return std::ranges::binary_search(sheet().pins, particle); }

  Edits edits_{viewer_};
};

TEST_F(HandToolsTest, ADragTakesTheParticleToTheCursorAndPushesNothing) {
  tap(' '), frames(30);
  grabMiddle({80, -60});
  const glm::dvec2 wanted = placeOf(210) + glm::dvec2(80, -60);
  frames(60);
  EXPECT_LT(glm::distance(placeOf(210), wanted), 1);
  EXPECT_EQ(viewer_.logLine().held, 210);
  release(kLeftButton);
  EXPECT_EQ(viewer_.logLine().held, -1);
  frames(30);
  EXPECT_EQ(countOf<PushEvent>(viewer_.run().record()), 0);
  EXPECT_EQ(countOf<ReleaseEvent>(viewer_.run().record()), 1);
  EXPECT_GT(glm::distance(placeOf(210), wanted), 5) << "it falls again";
  expectReplays();
}

TEST_F(HandToolsTest, AGrabStaysInThePlaneThatFacesTheViewerAndTheWheelMovesIt) {
  tap(' '), frames(30);
  const auto depth = [&] {
    const Vec3 at = viewer_.run().simulation().position(210);
    return glm::dot(glm::vec3(at.x, at.y, at.z) - viewer_.view().camera().eye(), viewer_.view().camera().forward());
  };
  const float before = depth();
  grabMiddle({50, 50});
  frames(60);
  EXPECT_NEAR(depth(), before, 1e-3);
  const glm::vec3 eye = viewer_.view().camera().eye();
  viewer_.handle({.kind = Kind::Scroll, .notches = 3});
  frames(60);
  EXPECT_GT(depth(), 1.1F * before);
  EXPECT_EQ(viewer_.view().camera().eye(), eye) << "the wheel is the hand's";
  release(kLeftButton);
  viewer_.handle({.kind = Kind::Scroll, .notches = 3});
  EXPECT_NE(viewer_.view().camera().eye(), eye);
}

TEST_F(HandToolsTest, AParticleThatIsLetGoFliesOnWithItsVelocity) {
  tap(' '), frames(30);
  const glm::dvec2 from = placeOf(210);
  pressAt(from);
  for (int k = 1; k < 20; ++k) moveTo(from + glm::dvec2(6 * k, -3 * k)), frames(1);
  const Vec3 held = viewer_.run().simulation().velocity(210);
  release(kLeftButton);
  EXPECT_EQ(viewer_.run().simulation().velocity(210), held);
  EXPECT_GT(std::hypot(held.x, held.y, held.z), 0.5);
}

TEST_F(HandToolsTest, AHandIsNeverFasterThanAFewSheetsPerSecondAndBreaksNoCloth) {
  tap(' '), frames(30);
  for (const Method& method : methods()) {
    tap('R');
    Scene scene = curtain();
    scene.integrator = method.name;
    viewer_.scenes().use(scene);
    tap(' '), frames(30);
    if (viewer_.run().state() != RunState::Running) continue;  // the method does not hold with this step anyway
    pressOnCloth();
    for (int k = 0; k < 40; ++k) {
      moveTo({k % 2 == 0 ? 10.0 : 1270.0, k % 3 == 0 ? 700.0 : 20.0});
      frames(2);
      const Vec3 v = viewer_.run().simulation().velocity(210);
      ASSERT_LE(std::hypot(v.x, v.y, v.z), 5.001 * sheet().size()) << method.name;
    }
    release(kLeftButton);
    frames(60);
    EXPECT_EQ(viewer_.run().state(), RunState::Running) << method.name << ": " << viewer_.run().failure().message();
  }
}

TEST_F(HandToolsTest, ADragOnAWaitingClothGrabsItAndStartsIt) {
  grabMiddle({60, 0});
  frames(60);
  EXPECT_EQ(viewer_.run().state(), RunState::Running);
  EXPECT_EQ(viewer_.logLine().held, 210);
  release(kLeftButton);
  frames(10);
  EXPECT_EQ(countOf<GrabEvent>(viewer_.run().record()) > 0, true);
  expectReplays();
}

TEST_F(HandToolsTest, AGrabOfAPausedClothWaitsUntilTimePasses) {
  tap(' '), frames(30), tap(' ');
  grabMiddle({60, 0});
  const glm::dvec2 wanted = placeOf(210) + glm::dvec2(60, 0);
  frames(10);
  EXPECT_EQ(viewer_.logLine().held, -1);
  EXPECT_TRUE(viewer_.run().record().events.empty());
  tap(' '), frames(60);
  EXPECT_LT(glm::distance(placeOf(210), wanted), 1);
}

TEST_F(HandToolsTest, RestartLostFocusAndAnotherToolLetGo) {
  const std::array<std::function<void()>, 4> ends{
      [this] { tap('R'), tap(' '); }, [this] { viewer_.handle({.kind = Kind::FocusLost}); }, [this] { tap(kPin); },
      [this] { viewer_.run().turnToTime(viewer_.run().shown().time() - 0.3), tap(' '); }};
  for (const auto& end : ends) {
    tap(kHand), tap('R'), tap(' '), frames(60);
    grabMiddle({60, 0});
    frames(10);
    ASSERT_EQ(viewer_.logLine().held, 210);
    end();
    frames(3);
    EXPECT_EQ(viewer_.logLine().held, -1);
    release(kLeftButton);
  }
}

TEST_F(HandToolsTest, APastThatEndsAmidAGrabGoesOnWithoutTheHand) {
  tap(' '), frames(30);
  grabMiddle({60, 0});
  frames(40);
  release(kLeftButton);
  frames(40);
  viewer_.run().turnToTime(viewer_.run().shown().time() - 0.9);
  frames(3);
  EXPECT_TRUE(std::ranges::binary_search(viewer_.run().shown().sheet().pins, 210)) << "as it was then";
  tap(' '), frames(3);
  EXPECT_EQ(viewer_.logLine().held, -1);
  expectReplays();
}

TEST_F(HandToolsTest, AClickWithThePinPinsWhereItIsAndAnotherFrees) {
  tap(' '), frames(60);
  tap(kPin);
  clickOnCloth();
  EXPECT_TRUE(pinned(210));
  const glm::dvec2 there = placeOf(210);
  frames(30);
  EXPECT_LT(glm::distance(placeOf(210), there), 0.01);
  EXPECT_TRUE(std::ranges::binary_search(viewer_.run().shown().sheet().pins, 210));
  clickOnCloth();
  EXPECT_FALSE(pinned(210));
  frames(30);
  EXPECT_GT(glm::distance(placeOf(210), there), 1);
  expectReplays();
  pressAt({5, 700}), release(kLeftButton);
  EXPECT_FALSE(viewer_.notes().text().empty()) << "beside the cloth there is nothing to pin";
  EXPECT_EQ(countOf<PinEvent>(viewer_.run().record()), 2);
}

TEST_F(HandToolsTest, ADragWithTheCutTakesTheSpringsItCrossesOverBothEdges) {
  cutBelowRow(9);
  for (int column = 0; column < 20; ++column)
    EXPECT_TRUE(sheet().missing.has(9 * 20 + column, Missing::Down)) << column;
  EXPECT_FALSE(sheet().missing.has(8 * 20 + 5, Missing::Down));
  EXPECT_EQ(viewer_.logLine().cuts, 1);
  frames(1);
  EXPECT_EQ(viewer_.run().shown().sheet().missing, sheet().missing) << "shown though time stands still";
  tap(' '), frames(60);
  expectReplays();
}

TEST_F(HandToolsTest, ALineIsShownWhileItIsDrawnAndNothingIsCutWithoutARelease) {
  tap(kCut);
  pressOnCloth(), moveTo({900, 500});
  ASSERT_TRUE(viewer_.tools().drawing().cut);
  EXPECT_EQ(viewer_.tools().drawing().cut->to, glm::vec2(900, 500));
  viewer_.handle({.kind = Kind::FocusLost});
  release(kLeftButton);
  EXPECT_FALSE(viewer_.tools().drawing().cut);
  clickOnCloth();
  EXPECT_FALSE(viewer_.notes().text().empty());
  drag({5, 700}, {50, 700});
  EXPECT_FALSE(viewer_.notes().text().empty());
  EXPECT_TRUE(viewer_.run().record().events.empty());
}

TEST_F(HandToolsTest, UndoTakesBackTheLastThingFirst) {
  tap(' '), frames(30), edits_.follow(viewer_);
  cutBelowRow(9), edits_.follow(viewer_);
  tap(kPin), clickOnCloth(), edits_.follow(viewer_);
  viewer_.tools().setStrength(3), edits_.follow(viewer_);
  frames(5);
  edits_.undo(viewer_), edits_.follow(viewer_);
  EXPECT_EQ(viewer_.tools().strength(), 1);
  EXPECT_TRUE(pinned(210));
  edits_.undo(viewer_), edits_.follow(viewer_);
  EXPECT_FALSE(pinned(210));
  EXPECT_EQ(viewer_.logLine().cuts, 1);
  edits_.undo(viewer_), edits_.follow(viewer_);
  EXPECT_TRUE(sheet().missing.none());
  EXPECT_FALSE(edits_.canUndo());
  for (int k = 0; k < 3; ++k) edits_.redo(viewer_), edits_.follow(viewer_);
  EXPECT_TRUE(pinned(210) && viewer_.logLine().cuts == 1 && viewer_.tools().strength() == 3);
  frames(20);
  expectReplays();
}

TEST_F(HandToolsTest, ARestartIsWholeAgainAndItsUndoKnowsOnlySettings) {
  cutBelowRow(9), edits_.follow(viewer_);
  viewer_.tools().setStrength(3), edits_.follow(viewer_);
  tap('R'), edits_.follow(viewer_);
  EXPECT_TRUE(sheet().missing.none());
  edits_.undo(viewer_), edits_.follow(viewer_);
  EXPECT_EQ(viewer_.tools().strength(), 1);
  EXPECT_FALSE(edits_.canUndo()) << "the cut belongs to a run that is over";
  EXPECT_TRUE(sheet().missing.none());
}

TEST_F(HandToolsTest, ALeftDragWithControlLooksAroundAndWithShiftComesNearer) {
  const Camera before = viewer_.view().camera();
  viewer_.handle({.kind = Kind::Press, .key = kLeftButton, .x = 600, .y = 300, .control = true});
  moveTo({640, 300});
  release(kLeftButton);
  EXPECT_NE(viewer_.view().camera().yaw(), before.yaw());
  moveTo({700, 300});
  const Camera turned = viewer_.view().camera();
  viewer_.handle({.kind = Kind::Press, .key = kLeftButton, .x = 700, .y = 300, .shift = true});
  moveTo({700, 200});
  release(kLeftButton);
  EXPECT_LT(viewer_.view().camera().distance(), turned.distance());
  EXPECT_EQ(viewer_.view().camera().yaw(), turned.yaw());
  EXPECT_TRUE(viewer_.run().record().events.empty());
}

}  // namespace
}  // namespace tyg

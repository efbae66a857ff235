// Who gets a press, a key and the wheel: the one order of receivers, with the panels and the text over the cloth drawn
// into nothing.
#include "ui/input_router.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "ui/frame_capture.h"
#include "ui/hud.h"
#include "ui/panels_fixture.h"

namespace tyg {
namespace {

TEST(InputRouter, TheFirstReceiverThatTakesAnEventEndsItsWay) {
  std::string asked;
  InputRouter router;
  router.add("first", [&](const WindowEvent&) { return asked += "1", false; });
  router.add("second", [&](const WindowEvent& event) { return asked += "2", event.key == 'B'; });
  router.add("third", [&](const WindowEvent& event) { return asked += "3", event.key == 'C'; });
  EXPECT_EQ(router.route({.key = 'B'}), "second");
  EXPECT_EQ(asked, "12");
  EXPECT_EQ(router.route({.key = 'C'}), "third");
  EXPECT_EQ(router.route({.key = 'D'}), "");
}

class WindowRouterTest : public PanelsFixture {
 protected:
  void frames(int count = 4) {
    for (int k = 0; k < count; ++k) {
      now_ += 1.0 / 60;
      viewer_.frame();
      panels_.follow(viewer_);
      ImGui::NewFrame();
      hud_.draw(viewer_, panels_);
      panels_.draw(viewer_);
      ImGui::Render();
    }
  }
  std::string_view pressAt(double x, double y) {
    return router_.route({.kind = Kind::Press, .key = kLeftButton, .x = x, .y = y});
  }
  std::string_view moveTo(double x, double y) { return router_.route({.kind = Kind::Move, .x = x, .y = y}); }
  std::string_view releaseAt(double x, double y) {
    return router_.route({.kind = Kind::Release, .key = kLeftButton, .x = x, .y = y});
  }
  std::string_view press(KeyCode key) { return router_.route({.kind = Kind::Press, .key = key}); }
  void runForASecond() {
    press(' ');
    frames(60);
    press(' ');
    frames();
  }
  static constexpr double kTimeLineY = 632;  // of 720, with text of 18 pixels

  Hud hud_{TextFonts{ImGui::GetIO().Fonts->Fonts[0], ImGui::GetIO().Fonts->Fonts[0], 18}};
  FrameCapture capture_{std::filesystem::temp_directory_path()};
  InputRouter router_ = windowRouter(panels_, hud_, capture_, viewer_);
};

TEST_F(WindowRouterTest, APressOnTheClothIsTheViewers) {
  frames();
  EXPECT_EQ(pressAt(640, 300), "viewer");
  EXPECT_EQ(releaseAt(640, 300), "viewer");
  EXPECT_EQ(viewer_.tools().record().uses, 1);
}

TEST_F(WindowRouterTest, APressOnTheBarOfToolsChoosesOneAndTouchesNoCloth) {
  frames();
  int chosen = 0;
  std::size_t slot = 0;
  for (double x = 300; x < 1000; x += 10) {
    if (pressAt(x, 18) == "buttons" && viewer_.tools().chosenSlot() != slot) ++chosen, ++slot;
    releaseAt(x, 18);
  }
  EXPECT_EQ(chosen, 2) << "from the hand to the pin, and on to the cut";
  EXPECT_EQ(viewer_.logLine().tool, "cut");
  EXPECT_TRUE(viewer_.run().record().events.empty() ||
              std::holds_alternative<PushEvent>(viewer_.run().record().events[0].action))
      << "what is beside the bar is the cloth's";
}

TEST_F(WindowRouterTest, APressOnAPanelIsThePanels) {
  panels_.toggle(InputAction::OpenControl);
  frames();
  EXPECT_EQ(pressAt(100, 200), "panels");
  EXPECT_EQ(viewer_.tools().record().uses, 0);
  EXPECT_EQ(pressAt(640, 300), "viewer");
}

TEST_F(WindowRouterTest, ThePauseHasATimeLineThatIsDraggedUntilTheRelease) {
  frames();
  EXPECT_EQ(pressAt(640, kTimeLineY), "viewer") << "before the start there is no past";
  moveTo(660, kTimeLineY), releaseAt(660, kTimeLineY);
  runForASecond();
  const double newest = viewer_.run().timeline().newest;
  EXPECT_EQ(pressAt(640, kTimeLineY), "time line");
  EXPECT_LT(viewer_.run().timeline().shown, newest);
  const double there = viewer_.run().timeline().shown;
  EXPECT_EQ(moveTo(300, 100), "time line") << "wherever the cursor is";
  EXPECT_LT(viewer_.run().timeline().shown, there);
  EXPECT_EQ(releaseAt(300, 100), "viewer");
  EXPECT_EQ(moveTo(310, 100), "viewer");
}

TEST_F(WindowRouterTest, AFailureHasButtonsThatTakeTheirPress) {
  runForASecond();
  viewer_.run().freeze("it broke");
  frames();
  std::string_view taker;
  for (double y = 500; y < 640 && taker != "buttons"; y += 5) {
    for (double x = 400; x < 880 && taker != "buttons"; x += 10) taker = pressAt(x, y);
  }
  EXPECT_EQ(taker, "buttons");
  EXPECT_NE(viewer_.run().state(), RunState::Frozen) << "the first one steps back";
}

TEST_F(WindowRouterTest, WhereATextFieldIsTypedIntoKeysAreImGuisButReleasesAreEverybodys) {
  frames();
  ImGui::GetIO().WantCaptureKeyboard = true;
  EXPECT_EQ(press(' '), "imgui");
  EXPECT_EQ(viewer_.run().state(), RunState::Waiting);
  EXPECT_EQ(router_.route({.kind = Kind::Release, .key = ' '}), "viewer");
  EXPECT_EQ(pressAt(640, 300), "viewer") << "a press of the mouse is not typed";
  ImGui::GetIO().WantCaptureKeyboard = false;
  EXPECT_EQ(press(' '), "viewer");
}

TEST_F(WindowRouterTest, TheWheelIsImGuisOverAPanelOnly) {
  frames();
  const WindowEvent wheel{.kind = Kind::Scroll, .key = kWheel, .notches = 1};
  const float distance = viewer_.view().camera().distance();
  ImGui::GetIO().WantCaptureMouse = true;
  EXPECT_EQ(router_.route(wheel), "imgui");
  EXPECT_EQ(viewer_.view().camera().distance(), distance);
  ImGui::GetIO().WantCaptureMouse = false;
  EXPECT_EQ(router_.route(wheel), "viewer");
  EXPECT_LT(viewer_.view().camera().distance(), distance);
}

TEST_F(WindowRouterTest, KeysGoToWhatTheyAreFor) {
  frames();
  EXPECT_EQ(press('K'), "panels");
  EXPECT_EQ(press(kEscapeKey), "panels") << "it closes the panel";
  EXPECT_EQ(press('Y'), "capture");
  EXPECT_EQ(press('Z'), "capture");
  EXPECT_EQ(router_.route({.kind = Kind::Press, .key = 'Y', .control = true}), "panels") << "it does again";
  EXPECT_EQ(press('X'), "viewer");
  EXPECT_EQ(press(kEscapeKey), "viewer");
  EXPECT_TRUE(viewer_.leaving());
}

TEST_F(WindowRouterTest, AClickOnAKeyOfTheListDoesWhatTheKeyDoes) {
  frames();
  const auto clickAt = [&](double x, double y) {
    const std::string_view taken = pressAt(x, y);
    for (const WindowEvent& key : hud_.takeKeys()) (void)router_.route(key);
    releaseAt(x, y);
    for (const WindowEvent& key : hud_.takeKeys()) (void)router_.route(key);
    return taken;
  };
  constexpr double kX = 40, kFirst = 63, kLine = 24.3;  // of text of 18 pixels
  EXPECT_EQ(clickAt(kX, kFirst), "buttons");
  EXPECT_EQ(viewer_.run().state(), RunState::Running);
  clickAt(kX, kFirst + 4 * kLine);
  EXPECT_TRUE(panels_.isOpen(InputAction::OpenControl));
  EXPECT_EQ(viewer_.tools().record().uses, 0);
}

TEST_F(WindowRouterTest, TheLongListOfKeysLiesOverAllAndClosesByEscOrAPress) {
  frames();
  press(functionKey(1));
  frames();
  ASSERT_TRUE(viewer_.view().showsAllKeys());
  EXPECT_EQ(press(kEscapeKey), "all keys");
  EXPECT_FALSE(viewer_.view().showsAllKeys());
  EXPECT_FALSE(viewer_.leaving());
  press('?');
  frames();
  EXPECT_EQ(pressAt(5, 5), "all keys");
  EXPECT_FALSE(viewer_.view().showsAllKeys());
  releaseAt(5, 5);
  press('?');
  frames();
  int chosen = 0;
  for (double y = 20; y < 700 && chosen == 0; y += 5) {  // some line of the last column chooses a method
    for (double x = 600; x < 940 && chosen == 0; x += 40) {
      if (!viewer_.view().showsAllKeys()) press('?'), frames();
      pressAt(x, y);
      for (const WindowEvent& key : hud_.takeKeys()) chosen += key.key == '4' ? 1 : 0, (void)router_.route(key);
      releaseAt(x, y);
      (void)hud_.takeKeys();
    }
  }
  EXPECT_EQ(chosen, 1);
  EXPECT_EQ(viewer_.scenes().method().name, "leapfrog");
}

}  // namespace
}  // namespace tyg

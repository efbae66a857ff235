// The panels without a window: keys open and close them, they stand at the edges, and ImGui's widgets change the scene.
#include "app/panels/panels.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <set>

#include "app/viewer.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

using Kind = WindowEvent::Kind;

/// Panels on a screen that is not there, with a mouse and a clock that the test moves.
class PanelsTest : public testing::Test {
 protected:
  PanelsTest() {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {1280, 720};
    io.IniFilename = nullptr;
    io.Fonts->Build();
    viewer_.resize({.width = 1280, .height = 720}, {.left = 200, .right = 200});
  }
  void frames(int count = 4) {
    for (int k = 0; k < count; ++k) {
      now_ += 1.0 / 60;
      viewer_.frame();
      panels_.follow(viewer_);
      ImGui::NewFrame();
      panels_.draw(viewer_);
      ImGui::Render();
    }
  }
  bool press(KeyCode key, bool control = false, bool shift = false) {
    return panels_.handle({.kind = Kind::Press, .key = key, .control = control, .shift = shift}, viewer_);
  }
  bool pressMouse(double x, double y) {
    return panels_.handle({.kind = Kind::Press, .key = kLeftButton, .x = x, .y = y}, viewer_);
  }

  struct Context {
    Context() { ImGui::CreateContext(); }
    ~Context() { ImGui::DestroyContext(); }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
  } context_;
  double now_ = 1;
  Viewer viewer_{loadScene("curtain", methodNames()), Settings{.threads = 1}, [this] { return now_; }};
  Panels panels_{18, viewer_};
};

TEST_F(PanelsTest, EveryPanelHasAKeyThatOpensAndClosesIt) {
  std::set<InputAction> actions;
  for (const PanelKind& kind : panelTable()) {
    EXPECT_TRUE(actions.insert(kind.action).second) << kind.title;
    const auto input = std::ranges::find(inputTable(), kind.action, &Input::action);
    ASSERT_NE(input, inputTable().end()) << kind.title;
    EXPECT_TRUE(press(input->key)) << kind.title;
    EXPECT_TRUE(panels_.isOpen(kind.action)) << kind.title;
    frames();
    EXPECT_TRUE(press(input->key)) << kind.title;
    EXPECT_FALSE(panels_.isOpen(kind.action)) << kind.title;
  }
}

TEST_F(PanelsTest, EscapeClosesTheOneOpenedLastAndThenLeaves) {
  for (const PanelKind& kind : panelTable()) panels_.toggle(kind.action);
  frames();
  for (std::size_t k = panelTable().size(); k-- > 0;) {
    EXPECT_TRUE(panels_.isOpen(panelTable()[k].action));
    EXPECT_TRUE(press(kEscapeKey));
    EXPECT_FALSE(panels_.isOpen(panelTable()[k].action));
  }
  EXPECT_FALSE(press(kEscapeKey));
}

TEST_F(PanelsTest, APanelStandsAtItsEdgeAndTakesOnlyTheClicksOnIt) {
  panels_.toggle(InputAction::OpenControl);
  frames();
  EXPECT_GT(panels_.width(Edge::Left), 100);
  EXPECT_LT(panels_.width(Edge::Left), 640);
  EXPECT_EQ(panels_.width(Edge::Right), 0);
  EXPECT_TRUE(pressMouse(100, 200));
  EXPECT_FALSE(pressMouse(640, 360));
  panels_.toggle(InputAction::OpenControl);
  EXPECT_FALSE(pressMouse(100, 200));
}

TEST_F(PanelsTest, ControlAndZUndoesAndBothWaysRedo) {
  frames();
  Scene changed = viewer_.scene();
  const double dt = changed.dt;
  changed.dt = 0.5 * dt;
  viewer_.use(changed);
  frames();
  EXPECT_TRUE(press('Z', true));
  EXPECT_EQ(viewer_.scene().dt, dt);
  EXPECT_TRUE(press('Y', true));
  EXPECT_EQ(viewer_.scene().dt, 0.5 * dt);
  press('Z', true);
  EXPECT_TRUE(press('Z', true, true));
  EXPECT_EQ(viewer_.scene().dt, 0.5 * dt);
}

TEST_F(PanelsTest, KeysWithControlAreNotTheViewers) {
  EXPECT_TRUE(press('S', true));
  EXPECT_FALSE(press('S'));
}

}  // namespace
}  // namespace tyg

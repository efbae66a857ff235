// The panels without a window: keys open and close them, they stand at the edges, and ImGui's widgets change the scene.
#include "ui/panels/panels.h"

#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <thread>

#include "ui/panels_fixture.h"

namespace tyg {
namespace {

class PanelsTest : public PanelsFixture {
 protected:
  static bool showsTooltip() {
    return std::ranges::any_of(ImGui::GetCurrentContext()->Windows, [](const ImGuiWindow* window) {
      return window->Active && (window->Flags & ImGuiWindowFlags_Tooltip) != 0;
    });
  }
  /// The only field of Control that is typed into without Ctrl; in its left half, the columns.
  void restOnTheSheetsField() {
    const ImRect panel = placeOf("Control");
    for (float y = panel.Max.y; y > panel.Min.y && ImGui::GetMouseCursor() != ImGuiMouseCursor_TextInput; y -= 6) {
      ImGui::GetIO().MousePos = {panel.Min.x + 6.5F * 18, y}, frames(2);
    }
  }
  static ImRect placeOf(const char* title) { return ImGui::FindWindowByName(title)->Rect(); }
  static bool folded(const char* title) { return ImGui::FindWindowByName(title)->Collapsed; }
  static void key(ImGuiKey key, bool down) {
#if IMGUI_VERSION_NUM >= 18700
    ImGui::GetIO().AddKeyEvent(key, down);
#else
    ImGui::GetIO().KeyMap[key] = key;
    ImGui::GetIO().KeysDown[key] = down;
#endif
  }
  void tap(ImGuiKey which) {
    key(which, true), frames(2);
    key(which, false), frames(2);
  }
  void type(const char* text) {
    ImGui::GetIO().AddInputCharactersUTF8(text);
    frames(2);
  }
  /// Into the fields of Control, from one to the next by Tab.
  void typeSheet(const char* columns, const char* rows) {
    restOnTheSheetsField();
    click(ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y);
    ASSERT_TRUE(ImGui::GetIO().WantTextInput);
    type(columns);
    if (*rows != 0) tap(ImGuiKey_Tab), type(rows);
    tap(ImGuiKey_Enter), frames();
  }
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
  Scene changed = viewer_.scenes().scene();
  const double dt = changed.dt;
  changed.dt = 0.5 * dt;
  viewer_.scenes().use(changed);
  frames();
  EXPECT_TRUE(press('Z', true));
  EXPECT_EQ(viewer_.scenes().scene().dt, dt);
  EXPECT_TRUE(press('Y', true));
  EXPECT_EQ(viewer_.scenes().scene().dt, 0.5 * dt);
  press('Z', true);
  EXPECT_TRUE(press('Z', true, true));
  EXPECT_EQ(viewer_.scenes().scene().dt, 0.5 * dt);
}

TEST_F(PanelsTest, TheControlPanelHoldsTheToleranceToWhatBodiesAllowAndSaysSo) {
  Scene scene = loadScene("curtain", methodNames());
  scene.integrator = "dopri54";
  scene.bodies = {{.shape = Shape::Plane, .at = {0, -3, 0}}};
  scene.contact = {.stiffness = 500, .layer = 0.01};
  fillContact(scene);
  scene.tolerance = 1e-3;
  viewer_.scenes().use(scene);
  panels_.toggle(InputAction::OpenControl);
  frames();
  EXPECT_DOUBLE_EQ(viewer_.scenes().scene().tolerance, 1e-5);
  EXPECT_NE(viewer_.notes().text().find("a thousandth of the layer of contact"), std::string::npos);
}

TEST_F(PanelsTest, KeysWithControlAreNotTheViewers) {
  EXPECT_TRUE(press('S', true));
  EXPECT_FALSE(press('S'));
}

TEST_F(PanelsTest, ControlAndCCopiesEveryOpenPanelWhereverTheMouseRests) {
  press('K'), press('=');
  frames(30);
  const ImRect control = placeOf("Control");
  const ImVec2 field{control.Min.x + 10 * 18, control.Min.y + 1.5F * 18};
  ImGui::GetIO().MousePos = field;
  for (float down = 0; down < 300 && !showsTooltip(); down += 6) {
    ImGui::GetIO().MousePos = {field.x, field.y + down}, frames(25);
  }
  ASSERT_TRUE(showsTooltip());
  press('C', true), frames(1);
  const std::string copied = ImGui::GetClipboardText();
  for (const char* words :
       {"rk4, step of", "Motion", "gravity", "precision", "\nEnergy", "kinetic", "work of pushes"}) {
    EXPECT_NE(copied.find(words), std::string::npos) << words << " is missing in\n" << copied;
  }
}

TEST_F(PanelsTest, TheChartReadsOutThePointUnderTheCursorAndAClickTakesIt) {
  viewer_.scenes().use(withSheet(loadScene("curtain", methodNames()), 4, 4));
  panels_.toggle(InputAction::OpenChart);
  frames();
  EXPECT_FALSE(showsTooltip());
  const Scene before = viewer_.scenes().scene();
  // The study has the lowest priority, so that a busy machine takes minutes for it.
  const auto givenUp = std::chrono::steady_clock::now() + std::chrono::minutes(4);
  // Where the points are is up to this machine's speed: the cursor goes over the plot until it finds one that holds.
  for (int k = 0; viewer_.scenes().scene() == before; ++k) {
    ASSERT_LT(std::chrono::steady_clock::now(), givenUp);
    if (k % 500 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(100));
    const auto x = float(780 + (k * 37) % 420), y = float(150 + (k * 23) % 220);
    ImGui::GetIO().MousePos = {x, y}, frames(2);
    if (showsTooltip()) click(x, y);
  }
  ImGui::GetIO().MousePos = {100, 600}, frames(3);
  EXPECT_FALSE(showsTooltip());
}

TEST_F(PanelsTest, AClickOnARunningPlotGoesBackToItsMoment) {
  for (const InputAction action : {InputAction::OpenEnergy, InputAction::OpenTraces}) {
    panels_.toggle(action);
    if (viewer_.run().state() != RunState::Running) viewer_.perform(InputAction::StartOrPause);
    frames(90);
    const double newest = viewer_.run().shown().time();
    ImGui::GetIO().MousePos = {1230, 140}, frames(2);
    EXPECT_TRUE(showsTooltip());
    click(1230, 140);
    EXPECT_EQ(viewer_.run().state(), RunState::Paused);
    EXPECT_LT(viewer_.run().shown().time(), newest);
    EXPECT_GT(viewer_.run().shown().time(), newest - 1);
    click(1250, 140);  // what came after it is still there
    EXPECT_GE(viewer_.run().shown().time(), newest);
    panels_.toggle(action);
  }
}

TEST_F(PanelsTest, TracesTakeAParticleThatIsClickedOnTheClothOnceTheyAreAskedTo) {
  panels_.toggle(InputAction::OpenTraces);
  frames();
  const glm::mat4 seen = viewer_.view().camera().projection(1280.0F / 720) * viewer_.view().camera().view();
  const glm::vec4 pin = seen * glm::vec4(viewer_.run().shown().positions()[0], viewer_.run().shown().positions()[1],
                                         viewer_.run().shown().positions()[2], 1);
  const double x = 640 * (1 + pin.x / pin.w), y = 360 * (1 - pin.y / pin.w);
  EXPECT_FALSE(pressMouse(x, y));
  bool taken = false;
  for (float button = 690; button > 200 && !taken; button -= 8) click(870, button), taken = pressMouse(x, y);
  EXPECT_TRUE(taken);
  EXPECT_FALSE(pressMouse(x, y));  // once
}

TEST_F(PanelsTest, HaveASizeInAWindowThatHasNone) {
  for (const PanelKind& kind : panelTable()) panels_.toggle(kind.action);
  for (const Extent size : {Extent{0, 0}, Extent{1, 1}, Extent{3, 700}, Extent{30, 700}, Extent{700, 2}}) {
    ImGui::GetIO().DisplaySize = {float(size.width), float(size.height)};
    viewer_.resize(size, {.left = int(panels_.width(Edge::Left)), .right = int(panels_.width(Edge::Right))});
    frames();
    EXPECT_GT(panels_.width(Edge::Right), 0) << size.width << " x " << size.height;
  }
  ImGui::GetIO().DisplaySize = {1280, 720};
  frames();
  EXPECT_TRUE(pressMouse(1000, 50));  // nobody dragged them away from their places
}

TEST_F(PanelsTest, StayWhereTheyAreDraggedTo) {
  panels_.toggle(InputAction::OpenGhost);
  frames();
  ImGuiIO& io = ImGui::GetIO();
  io.MousePos = {1000, 57}, frames(2);
  io.MouseDown[0] = true, frames(1);
  for (float x = 1000; x > 600; x -= 40) io.MousePos = {x, 157}, frames(1);
  io.MouseDown[0] = false, frames(2);
  EXPECT_EQ(panels_.width(Edge::Right), 0);
  EXPECT_TRUE(pressMouse(640, 157));
  EXPECT_FALSE(pressMouse(1200, 157));
}

TEST_F(PanelsTest, EndAboveWhatIsSaidBelowThem) {
  panels_.toggle(InputAction::OpenControl);
  panels_.endAbove(400);
  frames();
  EXPECT_TRUE(pressMouse(100, 390));
  EXPECT_FALSE(pressMouse(100, 410));
  panels_.endAbove(700);
  frames();
  EXPECT_TRUE(pressMouse(100, 410));
}

/// At the right edge, none of them over another.
std::vector<ImRect> shown(std::initializer_list<const char*> titles) {
  std::vector<ImRect> places;
  for (const char* title : titles) places.push_back(ImGui::FindWindowByName(title)->Rect());
  std::ranges::sort(places, {}, [](const ImRect& place) { return place.Min.y; });
  return places;
}

TEST_F(PanelsTest, WhereAnEdgeIsTooLowTheOldOnesFoldToTheirTitlesAndNothingOverlaps) {
  const auto titles = {"Energy", "Traces", "Stretch", "Ghost", "Chart"};
  for (const InputAction action : {InputAction::OpenEnergy, InputAction::OpenTraces, InputAction::OpenStretch,
                                   InputAction::OpenGhost, InputAction::OpenChart}) {
    panels_.toggle(action), frames();
  }
  panels_.endAbove(600), frames();
  EXPECT_FALSE(folded("Chart"));
  EXPECT_TRUE(folded("Energy"));
  const auto places = shown(titles);
  for (std::size_t k = 1; k < places.size(); ++k) EXPECT_GE(places[k].Min.y, places[k - 1].Max.y);
  EXPECT_LE(places.back().Max.y, 600);
  ImGui::GetIO().DisplaySize = {1920, 3000};
  panels_.endAbove(3000), frames();
  for (const char* title : titles) EXPECT_FALSE(folded(title)) << title;
}

TEST_F(PanelsTest, WhereTheWindowIsTooNarrowForBothEdgesTheOneOpenedLastLeavesTheClothItsRoom) {
  panels_.toggle(InputAction::OpenControl), panels_.toggle(InputAction::OpenChart);
  frames();
  EXPECT_FALSE(folded("Control") || folded("Chart")) << "there is room";
  EXPECT_EQ(panels_.titles(), 0);
  ImGui::GetIO().DisplaySize = {640, 400};
  panels_.endAbove(320);
  frames();
  EXPECT_TRUE(folded("Control"));
  EXPECT_FALSE(folded("Chart"));
  EXPECT_EQ(panels_.width(Edge::Left), 0);
  EXPECT_TRUE(panels_.isAt(Edge::Left));
  EXPECT_LT(panels_.width(Edge::Right), 0.5F * 640);
  const ImRect title = placeOf("Control");
  EXPECT_GE(panels_.titles(), title.GetHeight());
  click(title.Min.x + 60, title.GetCenter().y);
  frames();
  EXPECT_FALSE(folded("Control"));
  EXPECT_TRUE(folded("Chart"));
  EXPECT_EQ(panels_.width(Edge::Right), 0);
}

TEST_F(PanelsTest, OfLargeTextOpenInASmallWindow) {
  Panels large(36, viewer_);
  ImGui::GetIO().DisplaySize = {640, 400};
  large.endAbove(300);
  large.toggle(InputAction::OpenControl);
  for (int k = 0; k < 6; ++k) {
    ImGui::NewFrame();
    large.draw(viewer_);
    ImGui::Render();
  }
  EXPECT_FALSE(folded("Control"));
  EXPECT_GT(placeOf("Control").GetHeight(), 80);
}

TEST_F(PanelsTest, AClickOnAFoldedTitleMakesItTheNewest) {
  panels_.endAbove(420);
  panels_.toggle(InputAction::OpenEnergy), frames();
  panels_.toggle(InputAction::OpenTraces), frames();
  ASSERT_TRUE(folded("Energy"));
  const ImVec2 at = placeOf("Energy").GetCenter();
  EXPECT_TRUE(pressMouse(at.x, at.y));  // the panel's, not the cloth's
  ImGui::GetIO().MousePos = {600, 300}, frames(2);
  ImGui::GetIO().MouseDown[0] = true, frames(2);
  ImGui::GetIO().MousePos = at, frames(2);
  ImGui::GetIO().MouseDown[0] = false, frames(2);
  EXPECT_TRUE(folded("Energy"));  // a drag that ended there
  click(at.x, at.y);
  EXPECT_FALSE(folded("Energy"));
  EXPECT_TRUE(folded("Traces"));
  click(placeOf("Traces").Max.x - 10, placeOf("Traces").GetCenter().y);  // its x
  EXPECT_FALSE(panels_.isOpen(InputAction::OpenTraces));
  EXPECT_TRUE(panels_.isOpen(InputAction::OpenEnergy));
}

TEST_F(PanelsTest, AreDrawnSmallerWhereTheWindowIsTooNarrowForThem) {
  panels_.toggle(InputAction::OpenControl), frames();
  const auto inTextSizes = [] {
    const ImGuiWindow* window = ImGui::FindWindowByName("Control");
    return window->Rect().GetWidth() / window->FontWindowScale;
  };
  const float wide = inTextSizes();
  ImGui::GetIO().DisplaySize = {500, 720}, frames();
  EXPECT_LT(placeOf("Control").GetWidth(), 250);
  EXPECT_NEAR(inTextSizes(), wide, 2);
}

TEST_F(PanelsTest, ListsAndTooltipsHideWhatIsBelowThem) {
  panels_.toggle(InputAction::OpenControl);
  for (int background = 0; background < 2; ++background) {
    frames();
    EXPECT_EQ(ImGui::GetStyle().Colors[ImGuiCol_PopupBg].w, 1);
    viewer_.perform(InputAction::ChangeBackground);
  }
}

TEST_F(PanelsTest, ATooltipOfAFieldComesAtRestAndGoesBySelf) {
  panels_.toggle(InputAction::OpenControl), frames();
  restOnTheSheetsField();
  EXPECT_FALSE(showsTooltip()) << "not before the mouse has rested";
  frames(20);
  ASSERT_TRUE(showsTooltip());
  EXPECT_TRUE(panels_.busy());
  frames(300);
  EXPECT_FALSE(showsTooltip());
  EXPECT_FALSE(panels_.busy());
}

TEST_F(PanelsTest, TabGoesFromColumnsToRows) {
  panels_.toggle(InputAction::OpenControl), frames();
  typeSheet("7", "7");
  EXPECT_EQ(viewer_.scenes().scene().columns, 7);
  EXPECT_EQ(viewer_.scenes().scene().rows, 7);
}

TEST_F(PanelsTest, OfColumnsAndRowsTheOneThatIsNotTypedFollows) {
  viewer_.scenes().use(loadScene("hammock", methodNames()));
  panels_.toggle(InputAction::OpenControl), frames();
  typeSheet("12", "");
  EXPECT_EQ(viewer_.scenes().scene().columns, 12);
  EXPECT_EQ(viewer_.scenes().scene().rows, 8);
}

TEST_F(PanelsTest, OfColumnsAndRowsThatDoNotFitTheOneTypedLastRules) {
  panels_.toggle(InputAction::OpenControl), frames();
  typeSheet("7", "9");
  EXPECT_EQ(viewer_.scenes().scene().columns, 9);
  EXPECT_EQ(viewer_.scenes().scene().rows, 9);
}

TEST_F(PanelsTest, ASheetOfOtherSidesIsAnsweredWithTheNearestThatFits) {
  viewer_.scenes().use(loadScene("chain", methodNames()));
  panels_.toggle(InputAction::OpenControl), frames();
  typeSheet("2", "");
  EXPECT_EQ(viewer_.scenes().scene().columns, 1);
  EXPECT_NE(viewer_.notes().text().find("the nearest of which is 1x20"), std::string::npos) << viewer_.notes().text();
}

TEST_F(PanelsTest, ACountBeyondTheMostBecomesTheMostAndIsTold) {
  viewer_.scenes().use(loadScene("chain", methodNames()));
  panels_.toggle(InputAction::OpenControl), frames();
  typeSheet("1", "900");
  EXPECT_EQ(viewer_.scenes().scene().columns, 1);
  EXPECT_EQ(viewer_.scenes().scene().rows, 512);
  EXPECT_TRUE(viewer_.notes().text().starts_with("rows: 512 is the most")) << viewer_.notes().text();
  EXPECT_NE(viewer_.notes().text().find("smaller steps"), std::string::npos) << "nor does the step fit";
  EXPECT_LT(viewer_.scenes().scene().dt, 0.002);
}

}  // namespace
}  // namespace tyg

// The ghost's panel without a window: what it draws on the cloth, what it says, and what its widgets do.
#include <imgui_internal.h>

#include <chrono>
#include <string>
#include <thread>

#include "files.h"
#include "ui/panels_fixture.h"
#include "util/csv.h"

namespace tyg {
namespace {

class GhostPanelTest : public PanelsFixture {
 protected:
  /// What the uppermost panel says in a frame.
  std::string wordsOfFirst() {
    ImGui::NewFrame();
    ImGui::LogToClipboard();  // up to the end of a window
    panels_.draw(viewer_);
    ImGui::Render();
    return ImGui::GetClipboardText();
  }
  static bool says(const std::string& text, const char* words) { return text.find(words) != std::string::npos; }
  /// In the ghost's list of methods.
  void makeLeapfrogTheGhost() {
    panels_.toggle(InputAction::OpenGhost);
    frames();
    clickRow("Ghost", 0);
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const ImGuiWindow& list = *ImGui::FindWindowByName("##Combo_00");
    click(list.Pos.x + 30, list.Pos.y + ImGui::GetStyle().WindowPadding.y + 4.5F * line);
  }
  /// The middle of one of the rows of widgets below a panel's title.
  static float rowOf(const char* panel, int row) {
    const ImGuiWindow& window = *ImGui::FindWindowByName(panel);
    const float top = window.Pos.y + window.TitleBarHeight() + window.WindowPadding.y;
    return top + (float(row) + 0.5F) * ImGui::GetFrameHeightWithSpacing();
  }
  void clickRow(const char* panel, int row) { click(ImGui::FindWindowByName(panel)->Pos.x + 60, rowOf(panel, row)); }
};

TEST_F(GhostPanelTest, TheGhostAndTheClothAreSwappedAndBeginAnew) {
  viewer_.perform(InputAction::StartOrPause);
  makeLeapfrogTheGhost();
  frames(20);
  EXPECT_GT(viewer_.run().shown().time(), 0.2);
  clickRow("Ghost", 1);
  EXPECT_EQ(viewer_.scenes().method().name, "leapfrog");
  EXPECT_EQ(viewer_.run().state(), RunState::Running);
  EXPECT_LT(viewer_.run().shown().time(), 0.1);
  EXPECT_TRUE(says(wordsOfFirst(), "rk4"));  // the ghost's method
}

TEST_F(GhostPanelTest, TheGhostIsNotShownWhereItIsOfAnotherTime) {
  viewer_.perform(InputAction::StartOrPause);
  frames(60);
  panels_.toggle(InputAction::OpenGhost);
  const auto shown = [this] {
    ClothPicture picture{.options = viewer_.view().drawOptions()};
    panels_.paint(picture);
    return !picture.ghost.empty();
  };
  busy_ = 0.02;
  frames(1);
  EXPECT_FALSE(shown());
  EXPECT_TRUE(says(wordsOfFirst(), "catching up"));
  busy_ = 0;
  frames(1);
  EXPECT_TRUE(shown());
}

TEST_F(GhostPanelTest, AGhostOpenedOverAFrozenClothComesUpToItAndRests) {
  Scene wanted = viewer_.scenes().scene();
  wanted.dt = 0.01;  // the limit is 4 ms
  viewer_.scenes().use(wanted);
  viewer_.perform(InputAction::StartOrPause);
  for (int k = 0; k < 100 && viewer_.run().state() != RunState::Frozen; ++k) frames(1);
  ASSERT_EQ(viewer_.run().state(), RunState::Frozen);
  EXPECT_NE(viewer_.run().shown().tick(), viewer_.run().simulation().ticks());
  panels_.toggle(InputAction::OpenGhost);
  frames(10);
  EXPECT_TRUE(says(wordsOfFirst(), "RMS"));
  EXPECT_FALSE(panels_.busy());
}

TEST_F(GhostPanelTest, BesideTheClothItSaysWhichIsWhichAndTakesRoom) {
  makeLeapfrogTheGhost();
  EXPECT_EQ(panels_.beside(), 0);
  click(ImGui::FindWindowByName("Ghost")->Pos.x + 190, rowOf("Ghost", 2));
  EXPECT_TRUE(says(wordsOfFirst(), "left: ghost, leapfrog; right: the cloth, rk4"));
  EXPECT_GT(panels_.beside(), viewer_.run().simulation().sheet().size());
  panels_.toggle(InputAction::OpenGhost);
  EXPECT_EQ(panels_.beside(), 0);
}

TEST_F(GhostPanelTest, TheGhostSaysWhereTheColoursAreThoseOfAnotherPanel) {
  viewer_.perform(InputAction::StartOrPause);
  panels_.toggle(InputAction::OpenGhost);
  frames(20);
  const auto words = [this] {
    ClothPicture picture{.options = viewer_.view().drawOptions()};
    panels_.paint(picture);
    return wordsOfFirst();
  };
  EXPECT_FALSE(says(words(), "another panel"));
  panels_.toggle(InputAction::OpenStretch);
  frames();
  EXPECT_TRUE(says(words(), "another panel"));
}

TEST_F(GhostPanelTest, AMotionThatIsOpenedOpensThePanelWithItsVerdictAndIsDrawn) {
  const Folder folder;
  Scene scene = viewer_.scenes().scene();
  Simulation program(scene, findMethod(scene.integrator), {.threads = 1});
  std::string rows = csvLine("t", "particle", "x", "y", "z");
  for (int k = 0; k <= 10; ++k) {
    for (int particle = 0; particle < program.sheet().count(); ++particle) {
      const Vec3 at = program.position(particle);
      rows += csvLine(program.time(), particle, at.x, at.y, at.z);
    }
    program.tick(5);
  }
  viewer_.handle({.kind = Kind::Drop, .path = folder.write("mine.csv", rows).string()});
  frames();
  ASSERT_TRUE(panels_.isOpen(InputAction::OpenGhost)) << viewer_.notes().text();
  EXPECT_TRUE(says(wordsOfFirst(), "checking:"));
  for (int turn = 0; turn < 60000 && viewer_.review().check().stage == CheckProgress::Stage::Running; ++turn) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  frames();
  EXPECT_TRUE(says(wordsOfFirst(), "Right: your positions")) << wordsOfFirst();
  const auto drawn = [this] {
    ClothPicture picture{.options = viewer_.view().drawOptions()};
    panels_.paint(picture);
    return picture.ghost.size();
  };
  EXPECT_EQ(drawn(), 3U * 400);
  viewer_.scenes().use(loadScene("four-particles", methodNames()));
  frames();
  EXPECT_EQ(drawn(), 3U * 4) << "another sheet has the true motion as its ghost again";
}

}  // namespace
}  // namespace tyg

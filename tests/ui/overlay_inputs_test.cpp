// Inputs between two frames: ImGui is told of each of them, in as many frames as it needs.
#include "ui/windows/overlay_inputs.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <array>
#include <string>

namespace tyg {
namespace {

class OverlayInputsTest : public testing::Test {
 protected:
  OverlayInputsTest() {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {800, 600};
    io.IniFilename = nullptr;
    io.Fonts->Build();
    if (!OverlayInputs::needed()) return;
#if IMGUI_VERSION_NUM < 18700
    io.KeyMap[ImGuiKey_Backspace] = kBackspace;
    io.KeyMap[ImGuiKey_A] = 'A';
#endif
  }
  ~OverlayInputsTest() override { ImGui::DestroyContext(); }
  OverlayInputsTest(const OverlayInputsTest&) = delete;
  OverlayInputsTest& operator=(const OverlayInputsTest&) = delete;

  void SetUp() override {
    if (!OverlayInputs::needed()) GTEST_SKIP() << "this ImGui has a queue of its own";
    frames(3);
  }
  void frames(int count) {
    for (int k = 0; k < count; ++k) {
      ImGui::GetIO().DeltaTime = 0.2F;
      inputs_.give(ImGui::GetIO());
      ImGui::NewFrame();
      ImGui::SetNextWindowPos({0, 0});
      ImGui::SetNextWindowSize({400, 300});
      ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoTitleBar);
      clicks_ += ImGui::Button("first", {100, 40}) ? 1 : 0;
      others_ += ImGui::Button("second", {100, 40}) ? 1 : 0;
      ImGui::InputText("words", words_.data(), words_.size());
      if (focus_) ImGui::SetKeyboardFocusHere(-1);
      focus_ = false;
      ImGui::SliderFloat("slider", &slid_, 0, 1);
      sliderY_ = 0.5F * (ImGui::GetItemRectMin().y + ImGui::GetItemRectMax().y);
      ImGui::End();
      ImGui::Render();
    }
  }
  void whileBehind() {
    int most = 100;
    do frames(1);
    while (inputs_.waiting() && --most > 0);
    EXPECT_GT(most, 0);
    frames(2);
  }
  void click(float x, float y) {
    inputs_.move(x, y);
    inputs_.button(0, true), inputs_.button(0, false);
  }
  void tap(int code, bool edits) { inputs_.key(code, true, edits, {}), inputs_.key(code, false, edits, {}); }
  void type(char letter) {
    inputs_.key(letter - 'a' + 'A', true, false, {});
    inputs_.text(static_cast<unsigned>(letter));
    inputs_.key(letter - 'a' + 'A', false, false, {});
  }
  void beginTyping() {
    focus_ = true;
    frames(3);
  }

  static constexpr int kBackspace = 300;
  OverlayInputs inputs_;
  int clicks_ = 0, others_ = 0;
  float slid_ = 0, sliderY_ = 0;
  bool focus_ = false;
  std::array<char, 32> words_{};
};

TEST_F(OverlayInputsTest, AClickBetweenTwoFramesActsOnce) {
  click(50, 30);
  whileBehind();
  EXPECT_EQ(clicks_, 1);
  EXPECT_EQ(others_, 0);
}

TEST_F(OverlayInputsTest, ClicksOnTwoPlacesBetweenTwoFramesActOnBoth) {
  click(50, 30), click(50, 75), click(50, 30);
  inputs_.move(700, 500);
  whileBehind();
  EXPECT_EQ(clicks_, 2);
  EXPECT_EQ(others_, 1);
}

TEST_F(OverlayInputsTest, ADragBetweenTwoFramesReachesItsEnd) {
  inputs_.move(20, sliderY_);
  inputs_.button(0, true);
  for (float x = 30; x < 120; x += 10) inputs_.move(x, sliderY_);
  inputs_.button(0, false);
  whileBehind();
  EXPECT_GT(slid_, 0.2F);
}

TEST_F(OverlayInputsTest, LettersAndDeletionsBetweenTwoFramesKeepTheirOrder) {
  beginTyping();
  for (const char letter : std::string("abca")) type(letter);
  tap(kBackspace, true), tap(kBackspace, true);
  type('d'), type('d');
  whileBehind();
  EXPECT_STREQ(words_.data(), "abdd");
}

TEST_F(OverlayInputsTest, WordsTakeNoMoreFramesThanTheirLettersRepeat) {
  beginTyping();
  for (const char letter : std::string("word")) type(letter);
  frames(2);
  EXPECT_FALSE(inputs_.waiting());
  EXPECT_STREQ(words_.data(), "word");
}

TEST_F(OverlayInputsTest, AHeldKeyStaysDown) {
  inputs_.key('A', true, false, {.control = true});
  frames(3);
  EXPECT_TRUE(ImGui::IsKeyDown(ImGui::GetKeyIndex(ImGuiKey_A)));
  EXPECT_TRUE(ImGui::GetIO().KeyCtrl);
  inputs_.key('A', false, false, {});
  frames(1);
  EXPECT_FALSE(ImGui::IsKeyDown(ImGui::GetKeyIndex(ImGuiKey_A)));
  EXPECT_FALSE(ImGui::GetIO().KeyCtrl);
}

}  // namespace
}  // namespace tyg

// The text over the picture without a window: what gives way to what where there is little room.
#include "ui/hud.h"

#include <gtest/gtest.h>
#include <imgui_internal.h>

#include "ui/cloth_painter.h"
#include "ui/panels_fixture.h"

namespace tyg {
namespace {

class HudTest : public PanelsFixture {
 protected:
  HudTest() {
    ImGui::GetIO().DisplaySize = {640, 400};
    viewer_.resize({.width = 640, .height = 400}, {});
  }
  void drawOver() override { hud_.draw(viewer_, panels_); }
  /// Runs a scene that fails until it has.
  void fail() {
    viewer_.scenes().use(loadScene("fail-wet", methodNames()));
    viewer_.perform(InputAction::StartOrPause);
    for (int k = 0; k < 600 && viewer_.run().state() != RunState::Frozen; ++k) frames(1);
    ASSERT_EQ(viewer_.run().state(), RunState::Frozen);
    frames(8);
  }
  static bool folded(const char* title) { return ImGui::FindWindowByName(title)->Collapsed; }

  Hud hud_{{.text = ImGui::GetIO().Fonts->Fonts[0], .large = ImGui::GetIO().Fonts->Fonts[0], .size = 36}};
};

TEST_F(HudTest, WhatIsSaidOfAFailureGivesWayToAPanelOpenedSinceInALowWindow) {
  fail();
  const int said = hud_.below(viewer_);
  EXPECT_GT(said, 400 / 2);
  panels_.toggle(InputAction::OpenControl);
  frames(8);
  EXPECT_FALSE(folded("Control"));
  EXPECT_LT(hud_.below(viewer_), said);
  EXPECT_GT(hud_.below(viewer_), 400 / 3) << "the cloth is above all lines that stand for it";
  panels_.toggle(InputAction::OpenControl);
  frames(8);
  EXPECT_EQ(hud_.below(viewer_), said);
}

TEST_F(HudTest, AWindIsShownInARowThatIsFreeForIt) {
  EXPECT_EQ(hud_.windHeight(viewer_), 0) << "no wind";
  viewer_.scenes().use(loadScene("flag", methodNames()));
  frames(1);
  const int row = hud_.windHeight(viewer_);
  ASSERT_GT(row, 0);
  viewer_.resize({.width = 640, .height = 400}, {.left = 250, .right = 100, .top = 50 + row, .wind = row});
  const auto wind = shownWind(viewer_);
  ASSERT_TRUE(wind);
  const float across = wind->at.x * 640, half = wind->longest / 2 * 400;
  EXPECT_GE(across - half, 250 - 1);
  EXPECT_LE(across + half, 640 - 100);
  EXPECT_NEAR(wind->at.y * 400, 50 + float(row) / 2, 1);
}

TEST_F(HudTest, AFailureIsSaidThoughAPanelHasBeenOpenBefore) {
  panels_.toggle(InputAction::OpenControl);
  frames(8);
  EXPECT_FALSE(folded("Control"));
  fail();
  EXPECT_GT(hud_.below(viewer_), 400 / 2);
}

}  // namespace
}  // namespace tyg

// The view beside a panel that opens or closes, without a window: it fits the cloth as that moves by then.
#include <gtest/gtest.h>

#include "viewer/view_control.h"

namespace tyg {
namespace {

constexpr Extent kWindow{.width = 1280, .height = 720};
const Box kSquare{.low = {-1, -1, 0}, .high = {1, 1, 0}};

/// A square at rest, in a motion that may take up five times as much.
void open(ViewControl& view) {
  view.begin({{-5, -5, 0}, {5, 5, 0}});
  view.follow(kSquare, {}, false, true);
  view.resize(kWindow, {});
}

/// Frames of 0.02 s of a cloth whose box stays as it is.
void showSquare(ViewControl& view, int frames) {
  for (int frame = 0; frame < frames; ++frame) {
    view.follow(kSquare, {}, true, true);
    view.move({}, 0.02F);
  }
}

TEST(FitAnew, AClothWhoseMotionHasCalmedDownIsAsLargeBesideAPanelAsItCanBe) {
  for (const bool early : {true, false}) {  // the panel opens
    ViewControl view;
    open(view);
    const float near = view.camera().distance();
    showSquare(view, 60);
    if (early) view.resize(kWindow, {.left = 10});
    EXPECT_GT(view.camera().distance(), 2 * near) << "all that the motion may take up";
    showSquare(view, 500);
    if (!early) view.resize(kWindow, {.left = 10});
    EXPECT_LT(view.camera().distance(), 1.2F * near);
    view.follow(kSquare, {}, false, true);
    EXPECT_TRUE(view.glides()) << "at a restart it goes back";
  }
}

TEST(FitAnew, LinesOfTextThatComeAndGoAreNoReason) {
  ViewControl view;
  open(view);
  showSquare(view, 60);
  view.resize(kWindow, {.top = 10, .bottom = 30});
  const float distance = view.camera().distance();
  showSquare(view, 500);
  EXPECT_EQ(view.camera().distance(), distance);
  view.follow(kSquare, {}, false, true);
  EXPECT_FALSE(view.glides());
}

TEST(FitAnew, AViewThatThePersonHasChosenStays) {
  ViewControl view;
  open(view);
  showSquare(view, 60);
  view.orbit({30, 0}, {});
  const float distance = view.camera().distance();
  view.resize(kWindow, {.left = 10});
  showSquare(view, 500);
  EXPECT_NEAR(view.camera().distance(), distance, 1e-3F * distance);
}

}  // namespace
}  // namespace tyg

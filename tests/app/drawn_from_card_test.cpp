// The card computes in the context that draws, as in the window: the pictures are those of positions that were read
// back, and nothing is read back for them. Where there is no OpenGL 4.3, the tests say why and are skipped.
#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <tuple>

#include "core/forces/state.h"
#include "gfx/contexts/compute_context.h"
#include "gfx/contexts/offscreen_framebuffer.h"
#include "gfx/contexts/offscreen_kinds.h"
#include "gfx/passes/sheet_renderer.h"
#include "gpu/gpu_device.h"
#include "tyg/methods.h"
#include "viewer/viewer.h"

namespace tyg {
namespace {

constexpr Extent kWindow{320, 200};
constexpr glm::ivec2 kPixels{320, 200};
constexpr std::size_t kExtremes = 24;  // bytes of the box around the cloth, the camera's

class DrawnFromCard : public testing::Test {
 protected:
  void SetUp() override {
    try {
      context_ = makeComputeContext();
      device_ = std::make_shared<GpuDevice>(context_->find());
    } catch (const std::runtime_error& error) {
      GTEST_SKIP() << "no OpenGL 4.3 here: " << error.what();
    }
    loadOpenGl(context_->find());
    framebuffer_.make(kPixels.x, kPixels.y);
  }
  void TearDown() override {
    renderer_.reset(), viewer_.reset(), device_.reset();
    if (context_) framebuffer_.drop();
  }

  void open(const std::string& name) {
    Scene scene = loadScene(name, methodNames());
    scene.precision = Precision::Float, scene.integrator = "leapfrog", scene.dt = 0.0005;
    viewer_ = std::make_unique<Viewer>(scene, Settings{.threads = 1, .device = device_}, [this] { return now_; });
    viewer_->resize(kWindow, {});
    renderer_ = std::make_unique<SheetRenderer>(viewer_->run().simulation().sheet());
    viewer_->perform(InputAction::StartOrPause);
  }
  [[nodiscard]] const Simulation& simulation() const { return viewer_->run().simulation(); }
  [[nodiscard]] const ShownState& shown() const { return viewer_->run().shown(); }
  /// Of the positions and velocities on the card, with their padding.
  [[nodiscard]] std::size_t stateBytes() const {
    return 6 * sizeof(float) * static_cast<std::size_t>(Layout(simulation().sheet()).plane);
  }

  /// Returns how much it read back.
  std::size_t frame() {
    const std::size_t before = device_->bytesRead();
    now_ += 0.004;
    viewer_->frame();
    renderer_->follow(shown().sheet());
    draw(shown().drawn());
    return device_->bytesRead() - before;
  }
  void draw(const DrawnPositions& positions) {
    renderer_->draw(positions, viewer_->view().camera(), kPixels, {.show = show_});
  }
  Picture picture(const DrawnPositions& positions) {
    draw(positions);
    Picture picture;
    readFramebuffer(kPixels.x, kPixels.y, picture);
    return picture;
  }

  std::unique_ptr<ComputeContext> context_;
  OffscreenFramebuffer framebuffer_;
  std::shared_ptr<GpuDevice> device_;
  std::unique_ptr<Viewer> viewer_;
  std::unique_ptr<SheetRenderer> renderer_;
  Show show_ = Show::Lines;
  double now_ = 100;
};

TEST_F(DrawnFromCard, APlainFrameReadsBackNothingButTheBoxAroundTheCloth) {
  for (const Show show : {Show::Lines, Show::Surface, Show::Both}) {
    show_ = show;
    open("curtain");
    (void)frame();  // measures the largest stable step, as every half second
    for (int count = 0; count < 5; ++count) {
      const std::int64_t ticks = simulation().ticks();
      EXPECT_EQ(frame(), kExtremes) << int(show);
      EXPECT_GT(simulation().ticks(), ticks);
    }
    EXPECT_LT(simulation().steps(), 64);  // up to here no energy check was due
  }
}

TEST_F(DrawnFromCard, AnEnergyCheckReadsBackTheSumsOfTheRows) {
  open("curtain");
  (void)frame();
  std::size_t most = 0;
  while (simulation().steps() < 80) most = std::max(most, frame());
  EXPECT_GT(most, kExtremes);
  EXPECT_LT(most, stateBytes() / 20);
}

TEST_F(DrawnFromCard, PositionsAreReadBackOnceWhereSomebodyAsks) {
  open("curtain");
  for (int count = 0; count < 3; ++count) (void)frame();
  const std::size_t before = device_->bytesRead();
  const std::vector<float> asked(shown().positions().begin(), shown().positions().end());
  (void)shown().positions();
  EXPECT_EQ(device_->bytesRead() - before, asked.size() * sizeof(float));
  std::vector<float> expected(asked.size());
  simulation().copyPositions(expected);
  EXPECT_EQ(asked, expected);
}

TEST_F(DrawnFromCard, PicturesAndTheBoxAreThoseOfPositionsThatWereReadBack) {
  for (const auto& [scene, show] : {std::pair{"cut", Show::Lines}, {"storm", Show::Both}, {"flag", Show::Surface}}) {
    show_ = show;
    open(scene);
    for (int count = 0; count < 4; ++count) (void)frame();
    ASSERT_NE(shown().drawn().buffer(), 0U);
    const Picture there = picture(shown().drawn());
    const Box box = shown().box(), expected = boxAround(shown().positions());
    EXPECT_EQ(box.low, expected.low);
    EXPECT_EQ(box.high, expected.high);
    const Picture here = picture(DrawnPositions(shown().positions()));
    EXPECT_EQ(there.rgba, here.rgba) << scene;
    for (int count = 0; count < 4; ++count) (void)frame();
    EXPECT_NE(picture(shown().drawn()).rgba, here.rgba) << scene << ", which has moved on";
  }
}

TEST_F(DrawnFromCard, ThePersonTakesTheProcessorAndTheCardAgain) {
  open("curtain");
  viewer_->scenes().offerCard([this](const Scene&) { return OfferedCard{device_, "a card"}; });
  for (const bool onCard : {false, true}) {
    viewer_->scenes().moveOnCard(onCard);
    EXPECT_EQ(viewer_->run().state(), RunState::Running) << "it goes on running, from the start";
    for (int count = 0; count < 3; ++count) (void)frame();
    EXPECT_GT(simulation().ticks(), 0);
    EXPECT_EQ(shown().onDevice(), onCard);
    EXPECT_EQ(picture(shown().drawn()).rgba, picture(DrawnPositions(shown().positions())).rgba);
  }
}

TEST_F(DrawnFromCard, AFailureIsFoundAtTheTickWhereTheProcessorFindsItAndToldAlike) {
  const Scene scene = [] {
    Scene failing = loadScene("fail-stretched", methodNames());
    failing.precision = Precision::Float;
    return failing;
  }();
  const auto failAt = [&](const std::shared_ptr<Device>& device) {
    now_ = 100;
    Viewer viewer(scene, Settings{.threads = 1, .device = device}, [this] { return now_; });
    viewer.resize(kWindow, {});
    viewer.perform(InputAction::StartOrPause);
    for (int count = 0; count < 2000 && viewer.run().state() == RunState::Running; ++count) {
      now_ += 1.0 / 60;
      viewer.frame();
    }
    EXPECT_EQ(viewer.run().state(), RunState::Frozen);
    return std::tuple(viewer.run().simulation().alarmTime(), viewer.run().shown().tick(),
                      viewer.run().failure().message());
  };
  EXPECT_EQ(failAt(device_), failAt(nullptr));
}

// Between two energy checks a cloth on the card grows out of every window, and the camera would go after it.
TEST_F(DrawnFromCard, AClothThatBlowsUpDoesNotTakeTheCameraAway) {
  Scene scene = loadScene("curtain", methodNames());
  scene.precision = Precision::Float, scene.integrator = "leapfrog", scene.dt = 0.0028;
  const auto eyeAfterFailure = [&](const std::shared_ptr<Device>& device) {
    now_ = 100;
    Viewer viewer(scene, Settings{.threads = 1, .device = device}, [this] { return now_; });
    viewer.resize(kWindow, {});
    viewer.perform(InputAction::StartOrPause);
    for (int count = 0; count < 60; ++count) {
      now_ += 1.0 / 60;
      viewer.frame();
    }
    EXPECT_EQ(viewer.run().state(), RunState::Frozen);
    return viewer.view().camera().eye();
  };
  const glm::vec3 eye = eyeAfterFailure(device_), expected = eyeAfterFailure(nullptr);
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(eye[axis], expected[axis], 0.01) << axis;
}

}  // namespace
}  // namespace tyg

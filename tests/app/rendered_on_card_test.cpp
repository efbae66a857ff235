// `tyg render` with the card: pictures are drawn from where the positions were computed, and are those of the
// processor, drawn in the same context. Where there is no OpenGL 4.3, the tests say why and are skipped.
#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <string>

#include "app/output/moving_scene.h"
#include "app/output/render.h"
#include "files.h"
#include "gpu/gpu_device.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

constexpr std::size_t kExtremes = 24;  // bytes of the box around the cloth

class RenderedOnCard : public testing::Test {
 protected:
  void SetUp() override {
    request_.times = {0.004, 0.008, 0.012, 0.016};
    request_.size = {640, 400};
    request_.threads = 1;
    request_.out = folder_ / "frames";
    try {
      const std::unique_ptr<Offscreen> offscreen = makeOffscreenOnCard(8, 8);
      const GpuDevice here(offscreen->find());
    } catch (const std::runtime_error& error) {
      GTEST_SKIP() << "no OpenGL 4.3 here: " << error.what();
    }
  }

  static Scene opened(const std::string& name) {
    Scene scene = loadScene(name, methodNames());
    scene.precision = Precision::Float, scene.integrator = "leapfrog", scene.dt = 0.0005;
    return scene;
  }

  /// A card that leaves in bytesRead_ what it has read back when it goes.
  [[nodiscard]] std::shared_ptr<Device> countingCard(Offscreen::Find drawing) {
    return {new GpuDevice(drawing), [this](GpuDevice* card) {
              bytesRead_ = card->bytesRead();
              delete card;
            }};
  }
  /// Returns what `work` read back with the settings that it was given.
  template <class Work>
  [[nodiscard]] std::size_t bytesReadBy(const Work& work) {
    {
      const std::unique_ptr<Offscreen> offscreen = makeOffscreenOnCard(8, 8);
      work(Settings{.threads = 1, .device = countingCard(offscreen->find())});
    }
    return bytesRead_;
  }

  /// The files of all pictures, one after another, drawn by the same driver.
  [[nodiscard]] std::string drawn(const Scene& scene, bool onCard) {
    request_.chooseDevice = [this, onCard](Offscreen::Find drawing) {
      return onCard ? countingCard(drawing) : nullptr;
    };
    EXPECT_EQ(render(scene, request_), 0);
    if (request_.times.size() == 1) return contentsOf(request_.out);
    std::string files;
    for (std::size_t frame = 0; frame < request_.times.size(); ++frame) {
      files += contentsOf(request_.out / ("frame_0000" + std::to_string(frame) + ".png"));
    }
    return files;
  }
  void expectAlike(const std::string& name, Show show) {
    request_.show = show;
    const std::string here = drawn(opened(name), false), there = drawn(opened(name), true);
    EXPECT_FALSE(here.empty());
    EXPECT_TRUE(there == here) << name << ' ' << int(show);
  }

  Folder folder_;
  RenderRequest request_;
  std::size_t bytesRead_ = 0;
};

TEST_F(RenderedOnCard, ADrawnFrameReadsBackNothingButTheBoxAroundTheCloth) {
  const Scene scene = opened("curtain");
  const std::size_t scouting = bytesReadBy([&](const Settings& settings) {
    MovingScene scout(scene, settings, [](double) { return true; });
    for (const double time : request_.times) {
      ASSERT_TRUE(scout.reach(time));
      (void)scout.xyz();
    }
  });
  const std::size_t moving = bytesReadBy([&](const Settings& settings) {
    Simulation alone(scene, findMethod(scene.integrator), settings);
    for (const double time : request_.times) alone.advanceTo(time);
  });
  for (const Show show : {Show::Lines, Show::Surface, Show::Both}) {
    request_.show = show;
    EXPECT_FALSE(drawn(scene, true).empty());
    EXPECT_EQ(bytesRead_, scouting + moving + request_.times.size() * kExtremes) << int(show);
  }
}

TEST_F(RenderedOnCard, PicturesAreThoseOfTheProcessor) {
  request_.times = {0, 0.1, 0.2};
  for (const char* name : {"flag", "poke", "tear", "storm"}) {
    for (const Show show : {Show::Lines, Show::Surface, Show::Both}) expectAlike(name, show);
  }
}

// Normals that are off in their last bits show in a few shades of a surface that has crumpled.
TEST_F(RenderedOnCard, ASinglePictureIsThatOfTheProcessorInEveryShade) {
  request_.times = {0.9};
  request_.out = folder_ / "a.png";
  expectAlike("ball", Show::Surface);
}

}  // namespace
}  // namespace tyg

// `tyg render` with the card: pictures are drawn from where the positions were computed, and are those of the
// processor, drawn in the same context. Where there is no OpenGL 4.3, the tests say why and are skipped.
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "app/commands/device_options.h"
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
    openOffscreenFor(request_, true);
    const Scene any = opened("curtain");
    const GlFinder drawing = request_.offscreen->find();
    request_.device = chosenDevice({.device = "gpu"}, any, 1, "this test", drawing).device;
    if (!request_.device) GTEST_SKIP() << "no OpenGL 4.3 here";
  }

  static Scene opened(const std::string& name) {
    Scene scene = loadScene(name, methodNames());
    scene.precision = Precision::Float, scene.integrator = "leapfrog", scene.dt = 0.0005;
    return scene;
  }

  /// Returns what `work` read back from the card.
  template <class Work>
  [[nodiscard]] std::size_t bytesReadBy(const Work& work) const {
    const auto& card = dynamic_cast<const GpuDevice&>(*request_.device);
    const std::size_t before = card.bytesRead();
    work();
    return card.bytesRead() - before;
  }

  /// The files of all pictures, one after another.
  [[nodiscard]] std::string drawn(const Scene& scene, const std::shared_ptr<Device>& device) const {
    RenderRequest request = request_;
    request.device = device;
    EXPECT_EQ(render(scene, request), 0);
    if (request.times.size() == 1) return contentsOf(request.out);
    std::string files;
    for (std::size_t frame = 0; frame < request.times.size(); ++frame) {
      files += contentsOf(request.out / ("frame_0000" + std::to_string(frame) + ".png"));
    }
    return files;
  }
  void expectAlike(const std::string& name, Show show) {
    request_.show = show;
    const std::string here = drawn(opened(name), nullptr), there = drawn(opened(name), request_.device);
    EXPECT_FALSE(here.empty());
    EXPECT_TRUE(there == here) << name << ' ' << int(show);
  }

  Folder folder_;
  RenderRequest request_;
};

TEST_F(RenderedOnCard, ADrawnFrameReadsBackNothingButTheBoxAroundTheCloth) {
  const Scene scene = opened("curtain");
  const Settings settings{.threads = 1, .device = request_.device};
  const std::size_t scouting = bytesReadBy([&] {
    MovingScene scout(scene, settings, [](double) { return true; });
    for (const double time : request_.times) {
      ASSERT_TRUE(scout.reach(time));
      (void)scout.xyz();
    }
  });
  const std::size_t moving = bytesReadBy([&] {
    Simulation alone(scene, findMethod(scene.integrator), settings);
    for (const double time : request_.times) alone.advanceTo(time);
  });
  for (const Show show : {Show::Lines, Show::Surface, Show::Both}) {
    request_.show = show;
    const std::size_t all = bytesReadBy([&] { EXPECT_EQ(render(scene, request_), 0); });
    EXPECT_EQ(all, scouting + moving + request_.times.size() * kExtremes) << int(show);
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

// The viewer's frames only cut time into pieces: every frame rate moves the cloth through the same states.
#include <gtest/gtest.h>

#include "test_systems.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"
#include "view/frame_clock.h"

namespace tyg::test {
namespace {

constexpr std::int64_t kTicks = 700;
constexpr std::int64_t kClick = 200;  // the tick before which a click pushes

/// Frames of these lengths (s), over and over, until the cloth has moved for kTicks ticks.
std::uint64_t hashAfterFrames(const Scene& scene, const std::vector<double>& frames) {
  Simulation simulation(scene, findMethod(scene.integrator));
  FrameClock clock(scene.dt);
  for (std::size_t frame = 0; simulation.ticks() < kTicks; ++frame) {
    const int due = clock.due(frames[frame % frames.size()]);
    for (int n = 0; n < due && simulation.ticks() < kTicks; ++n) {
      if (simulation.ticks() == kClick) simulation.push(7, {0, 0, 3}, 20);
      simulation.tick();
    }
    clock.ran(due);
  }
  return simulation.hash();
}

TEST(FrameRates, ThirtySixtyAndAHundredAndFortyFourGiveTheSameStates) {
  Scene scene = softSheet(Damping::Relative);
  scene.dt = 0.003;
  for (const std::string_view method : methodNames()) {
    scene.integrator = method;
    const std::uint64_t steady = hashAfterFrames(scene, {1.0 / 60});
    EXPECT_EQ(hashAfterFrames(scene, {1.0 / 30}), steady) << method;
    EXPECT_EQ(hashAfterFrames(scene, {1.0 / 144}), steady) << method;
    EXPECT_EQ(hashAfterFrames(scene, {0.001, 0.05, 0.0001, 0.3, 0.016}), steady) << method;
  }
}

}  // namespace
}  // namespace tyg::test

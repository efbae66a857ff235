// What is said of an advice, without the search for one.
#include "app/reports/advice_report.h"

#include <gtest/gtest.h>

#include "core/simulation/device.h"
#include "tyg/input_error.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

/// A promise of half a millisecond a frame for a budget of one.
Advice promised(const Scene& scene) {
  Advice advice;
  advice.request.budget = 1e-3;
  advice.promise.emplace();
  advice.promise->scene = scene;
  advice.promise->error = 1e-6;
  advice.promise->seconds = 0.5e-3 * 60 * scene.duration;
  advice.achieved = 1e-6, advice.measured = advice.promise->seconds;
  advice.met = advice.proven = advice.held = true;
  return advice;
}
bool says(const Scene& scene, const Advice& advice, const char* words) {
  return adviceText(scene, advice).find(words) != std::string::npos;
}

TEST(AdviceReport, SaysThatAPromiseHoldsOnlyWhereTheClockDoesNotGainsayIt) {
  const Scene scene = loadScene("curtain", methodNames());
  Advice advice = promised(scene);
  EXPECT_TRUE(says(scene, advice, "The promise holds."));
  advice.measured *= 3;
  EXPECT_FALSE(says(scene, advice, "The promise holds."));
  EXPECT_TRUE(says(scene, advice, "by the clock it did not"));
  advice.held = false;
  EXPECT_TRUE(says(scene, advice, "The promise does NOT hold."));
}

TEST(AdviceReport, OfAnErrorSaysWhereTheClockFoundAMuchHigherCost) {
  const Scene scene = loadScene("curtain", methodNames());
  Advice advice = promised(scene);
  advice.request = {.error = 1e-3};
  advice.measured = 1.3 * advice.promise->seconds;
  EXPECT_FALSE(says(scene, advice, "The cost came out higher"));
  advice.measured = 1.7 * advice.promise->seconds;
  EXPECT_TRUE(says(scene, advice, "The promise holds."));
  EXPECT_TRUE(says(scene, advice, "The cost came out higher"));
}

/// A device that nobody asks for an integrator.
class NamedDevice final : public Device {
 public:
  [[nodiscard]] std::unique_ptr<Integrator<float>> make(const Method& method, const Scene& /*scene*/,
                                                        const Sheet& /*sheet*/) override {
    throw InputError("found " + std::string(method.name));
  }
};

TEST(AdviceReport, SaysWhichDeviceIsFaster) {
  const Scene scene = loadScene("curtain", methodNames());
  Advice advice = promised(scene);
  const auto saysOfCard = [&](const std::string& words) {
    return adviceText(scene, advice, {.device = "gpu", .name = "Card X"}).find(words) != std::string::npos;
  };
  EXPECT_FALSE(says(scene, advice, "\ndevice ")) << "without a card there is nothing to say";
  EXPECT_TRUE(saysOfCard("\ndevice        processor: the graphics card Card X does not take this setting\n"));
  advice.promise->elsewhere = 30 * advice.promise->seconds;
  EXPECT_TRUE(saysOfCard("\ndevice        processor: the graphics card Card X takes 30 times as long\n"));
  EXPECT_FALSE(saysOfCard("--device"));
  advice.promise->device = std::make_shared<NamedDevice>();
  EXPECT_TRUE(saysOfCard("\ndevice        graphics card Card X: the processor takes 30 times as long\n"));
  EXPECT_TRUE(saysOfCard(", the graphics card\n"));
  EXPECT_TRUE(saysOfCard(" --device gpu\n"));
}

}  // namespace
}  // namespace tyg

// What is said of an advice, without the search for one.
#include "app/reports/advice_report.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace tyg

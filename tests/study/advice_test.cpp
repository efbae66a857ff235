// Advice on small scenes, with work priced by the particle, not by a clock.
#include "study/advice/advice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "core/simulation/device.h"
#include "study/limits/stability.h"
#include "test_systems.h"
#include "tyg/methods.h"

namespace tyg::test {
namespace {

double plainCost(const Scene& scene, int threads) {
  const double solve = scene.integrator == "backward-euler" ? 20 : scene.integrator == "imex" ? 5 : 1;
  return 3e-7 * solve * scene.columns * scene.rows * (scene.precision == Precision::Float ? 0.6 : 1) / threads;
}

AdvicePlan planFor(const Request& request) {
  AdvicePlan plan;
  plan.request = request;
  for (const Method& method : methods()) plan.methods.push_back(&method);
  plan.cost = plainCost;
  plan.mostSeconds = 0.2, plan.allSeconds = 1;  // s of this price: some hundred thousand steps
  plan.clock = [now = 0.0](int) mutable { return now += 1e-3; };
  return plan;
}

/// Without the methods that solve equations, which take most of a search's time.
AdvicePlan explicitPlanFor(const Request& request) {
  AdvicePlan plan = planFor(request);
  std::erase_if(plan.methods, [](const Method* m) { return m->name == "backward-euler" || m->name == "imex"; });
  return plan;
}

Scene small() {
  Scene scene = softSheet(Damping::Relative);
  scene.duration = 0.5;
  return scene;
}

TEST(Advice, APromisedErrorHoldsAgainstTheReference) {
  for (const double error : {1e-2, 1e-4, 1e-7}) {
    const Advice advice = adviseOn(small(), planFor({.error = error}));
    ASSERT_TRUE(advice.met && advice.proven) << error;
    EXPECT_TRUE(advice.held) << error << " " << advice.achieved;
    EXPECT_LE(advice.achieved, error);
    EXPECT_GT(advice.measured, 0);
  }
}

TEST(Advice, ItHoldsOnRandomScenesOfFixedSeeds) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    Numbers numbers(seed);
    Scene scene = randomScene(3, 4, numbers);
    scene.duration = 0.2;
    scene.drag = std::fmin(scene.drag, 0.1);
    const Request request{.error = 1e-3 * makeSheet(scene).size()};
    const Advice advice = adviseOn(scene, planFor(request));
    EXPECT_TRUE(advice.held) << "seed " << seed << ": " << advice.achieved << " m of " << request.error;
  }
}

TEST(Advice, ASmallerErrorCostsMoreAndTenTimesBetterIsPriced) {
  const Advice rough = quickAdvice(small(), planFor({.error = 1e-3})),
               fine = quickAdvice(small(), planFor({.error = 1e-8}));
  ASSERT_TRUE(rough.met && fine.met);
  EXPECT_LT(rough.promise->seconds, fine.promise->seconds);
  ASSERT_TRUE(fine.tenTimesBetter);
  EXPECT_LE(fine.tenTimesBetter->error, 1e-9);
  EXPECT_GE(fine.tenTimesBetter->seconds, fine.promise->seconds);
}

TEST(Advice, StaysInsideTheMethodsLimit) {
  Scene scene = small();
  scene.structural.ks = 3e3;
  const Advice advice = quickAdvice(scene, planFor({.error = 0.05}));
  ASSERT_TRUE(advice.met);
  if (!findMethod(advice.promise->scene.integrator).adaptive && advice.limit > 0) {
    EXPECT_LE(advice.promise->scene.dt, 0.96 * advice.limit);
  }
  EXPECT_EQ(advice.promise->status, Status::Ok);
}

TEST(Advice, ABudgetIsKeptAndTheRestOfItBuysExactness) {
  Scene scene = small();
  const double step = plainCost(scene, 1);
  const Advice poor = adviseOn(scene, explicitPlanFor({.budget = 2 * step})),
               rich = adviseOn(scene, explicitPlanFor({.budget = 40 * step}));
  for (const Advice* advice : {&poor, &rich}) {
    ASSERT_TRUE(advice->met);
    EXPECT_TRUE(advice->held);
    EXPECT_LE(frameSeconds(advice->promise->seconds, scene.duration), advice->request.budget);
  }
  EXPECT_LT(rich.promise->error, 0.01 * poor.promise->error);
}

TEST(Advice, WhatCannotBeMetIsAnsweredWithTheNearest) {
  const Advice exact = quickAdvice(small(), explicitPlanFor({.error = 1e-19}));
  EXPECT_FALSE(exact.met);
  ASSERT_TRUE(exact.promise);
  EXPECT_LT(exact.promise->error, 1e-8);
  const Advice cheap = quickAdvice(small(), explicitPlanFor({.budget = 1e-12}));
  EXPECT_FALSE(cheap.met);
  ASSERT_TRUE(cheap.promise);
  EXPECT_GT(frameSeconds(cheap.promise->seconds, small().duration), 1e-12);
}

TEST(Advice, AGenerousBudgetBuysNoMoreThanCanBeKnown) {
  const double hour = 3600;
  const Advice advice = adviseOn(small(), planFor({.budget = hour}));
  ASSERT_TRUE(advice.met && advice.held);
  EXPECT_LE(advice.promise->error, advice.knowable);
  EXPECT_LT(advice.knowable, 1e-11);
  EXPECT_LT(advice.promise->work, 100000) << "it has an hour of seconds, but no use for them";
  EXPECT_LT(advice.runs, 80);
  EXPECT_FALSE(advice.tenTimesBetter);
  EXPECT_EQ(advice.tenTimesUpTo, 0) << "nothing ten times better can be known";
}

TEST(Advice, WhatCannotBeKnownIsNotSearchedFor) {
  const Advice advice = adviseOn(small(), planFor({.error = 1e-25}));
  ASSERT_TRUE(advice.promise);
  EXPECT_FALSE(advice.met);
  EXPECT_LE(advice.promise->error, advice.knowable);
  EXPECT_LT(advice.runs, 80);
  EXPECT_FALSE(advice.tenTimesBetter);
}

TEST(Advice, TenTimesBetterIsWithinATenthOrSaysHowFarItLooked) {
  for (const Request& request : {Request{.error = 1e-4}, Request{.budget = 4 * plainCost(small(), 1)}}) {
    const Advice advice = quickAdvice(small(), planFor(request));
    ASSERT_TRUE(advice.met);
    const double asked = request.error > 0 ? request.error : advice.promise->error;
    ASSERT_TRUE(advice.tenTimesBetter || advice.tenTimesUpTo > 0);
    if (advice.tenTimesBetter) {
      EXPECT_LE(advice.tenTimesBetter->error, asked / 10);
    }
  }
}

TEST(Advice, ThreadsAreTakenOnlyWhereTheyPay) {
  AdvicePlan plan = explicitPlanFor({.error = 1e-3});
  plan.threads = {1, 2};
  EXPECT_EQ(quickAdvice(small(), plan).threads, 2);
  plan.cost = [](const Scene& scene, int threads) { return plainCost(scene, 1) * (threads == 1 ? 1 : 0.95); };
  EXPECT_EQ(quickAdvice(small(), plan).threads, 1) << "a gain of a twentieth is none";
}

/// A device that is the processor.
class ProcessorAsDevice final : public Device {
 public:
  [[nodiscard]] std::unique_ptr<Integrator<float>> make(const Method& method, const Scene& scene,
                                                        const Sheet& sheet) override {
    ++made_;
    return method.make<float>(scene, sheet);
  }
  [[nodiscard]] int made() const { return made_; }

 private:
  int made_ = 0;
};

/// A device that knows leapfrog alone and takes so many times as long as the processor.
DeviceOffer offerOf(const std::shared_ptr<Device>& device, double times) {
  return {device, [times](const Scene& scene, int) {
            const bool takes = scene.integrator == "leapfrog" && scene.precision == Precision::Float;
            return takes ? times * plainCost(scene, 1) : std::numeric_limits<double>::infinity();
          }};
}

TEST(Advice, ADeviceIsTakenWhereItIsCheaper) {
  constexpr double kTimes = 1.0 / 20;
  const auto device = std::make_shared<ProcessorAsDevice>();
  AdvicePlan plan = explicitPlanFor({.error = 1e-3});
  plan.device = offerOf(device, kTimes);
  const Advice advice = adviseOn(small(), plan);
  ASSERT_TRUE(advice.met && advice.held);
  EXPECT_EQ(advice.promise->device, device);
  EXPECT_EQ(advice.promise->scene.integrator, "leapfrog");
  EXPECT_EQ(advice.promise->scene.precision, Precision::Float);
  EXPECT_NEAR(advice.promise->elsewhere * kTimes, advice.promise->seconds, 1e-9 * advice.promise->seconds);
  EXPECT_GT(device->made(), 0);
}

TEST(Advice, ADeviceIsLeftAloneWhereItIsDearer) {
  constexpr double kTimes = 20;
  const auto device = std::make_shared<ProcessorAsDevice>();
  AdvicePlan plan = explicitPlanFor({.error = 1e-3});
  std::erase_if(plan.methods, [](const Method* method) { return method->name != "leapfrog"; });
  plan.precisions = {Precision::Float};
  plan.device = offerOf(device, kTimes);
  const Advice advice = quickAdvice(small(), plan);
  ASSERT_TRUE(advice.met);
  EXPECT_EQ(advice.promise->device, nullptr);
  EXPECT_EQ(device->made(), 0);
  EXPECT_NEAR(advice.promise->elsewhere, kTimes * advice.promise->seconds, 1e-9 * advice.promise->elsewhere);
}

TEST(Advice, AnObserverThatSaysStopEndsIt) {
  AdvicePlan plan = planFor({.error = 1e-6});
  plan.observer = [calls = 0](double) mutable { return ++calls < 5; };
  EXPECT_TRUE(adviseOn(small(), plan).stopped);
}

}  // namespace
}  // namespace tyg::test

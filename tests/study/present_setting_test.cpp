// Settings among rows that obey exact laws: error = c h^p, cost = k/h.
#include "study/advice/present_setting.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tyg/methods.h"

namespace tyg {
namespace {

using Kind = SettingEstimate::Kind;
constexpr double kTolerance = 1e-9;  // relative: logarithms and powers round
constexpr double kFloor = 1e-13;     // m

WorkRow heldRow(std::string_view method, double dt, double error, double seconds) {
  WorkRow row;
  row.integrator = method;
  row.dt = dt, row.rmsError = error, row.seconds = seconds, row.floor = kFloor;
  return row;
}
WorkRow failedRow(std::string_view method, double dt) {
  WorkRow row;
  row.integrator = method;
  row.dt = dt, row.status = RowStatus::Unstable, row.seconds = 1e-5;
  return row;
}
double rk4Error(double h) { return 1e6 * std::pow(h, 4); }

/// rk4 fails at 8 ms and holds at 4, 2 and 1; symplectic Euler holds at 4 and 1.
std::vector<WorkRow> someRows() {
  std::vector<WorkRow> rows{failedRow("rk4", 8e-3)};
  for (const double h : {4e-3, 2e-3, 1e-3}) rows.push_back(heldRow("rk4", h, rk4Error(h), 4e-5 / h));
  for (const double h : {4e-3, 1e-3}) rows.push_back(heldRow("symplectic-euler", h, h, 1e-5 / h));
  return rows;
}
SettingEstimate rk4At(double dt) { return estimateOf(someRows(), {&findMethod("rk4"), dt, 0}); }
void expectOnTheLaw(const SettingEstimate& estimate, double h) {
  EXPECT_NEAR(estimate.error, rk4Error(h), kTolerance * rk4Error(h));
  EXPECT_NEAR(estimate.seconds, 4e-5 / h, kTolerance * 4e-5 / h);
}

TEST(PresentSetting, BetweenTwoRowsLiesOnTheirLineAndOnARowIsMeasured) {
  for (const double h : {1e-3, 1.3e-3, 2e-3, 3.9e-3, 4e-3}) {
    SCOPED_TRACE(h);
    const bool row = h == 1e-3 || h == 2e-3 || h == 4e-3;
    EXPECT_EQ(rk4At(h).kind, row ? Kind::Measured : Kind::Between);
    expectOnTheLaw(rk4At(h), h);
  }
}

TEST(PresentSetting, BeyondTheRowsFollowsTheOrder) {
  EXPECT_EQ(rk4At(5e-4).kind, Kind::Finer);
  expectOnTheLaw(rk4At(5e-4), 5e-4);
  EXPECT_EQ(rk4At(6e-3).kind, Kind::Coarser);
  expectOnTheLaw(rk4At(6e-3), 6e-3);
  EXPECT_EQ(rk4At(1e-9).error, kFloor);
}

TEST(PresentSetting, FailsWhereTheRowsFailed) {
  EXPECT_EQ(rk4At(8e-3).kind, Kind::Fails);
  EXPECT_EQ(rk4At(1).kind, Kind::Fails);
}

TEST(PresentSetting, FailsPastTheLimitEvenWhereNoRowFailedYet) {
  const std::vector<WorkRow> rows{heldRow("rk4", 4e-3, rk4Error(4e-3), 0.01), failedRow("rk4", 8e-3)};
  EXPECT_EQ(estimateOf(rows, {&findMethod("rk4"), 5.3e-3, 0, 4.26e-3}).kind, Kind::Fails);
  EXPECT_EQ(estimateOf(rows, {&findMethod("rk4"), 4.2e-3, 0, 4.26e-3}).kind, Kind::Coarser);
}

TEST(PresentSetting, OfAMethodWithoutRowsIsUnknown) {
  EXPECT_EQ(estimateOf(someRows(), {&findMethod("leapfrog"), 1e-3, 0}).kind, Kind::Unknown);
  EXPECT_EQ(estimateOf({failedRow("rk4", 8e-3)}, {&findMethod("rk4"), 1e-3, 0}).kind, Kind::Unknown);
}

TEST(PresentSetting, OfAnAdaptiveMethodGoesByItsTolerance) {
  WorkRow coarse = heldRow("dopri54", 0.01, 1e-3, 0.1), fine = heldRow("dopri54", 0.004, 1e-5, 0.2);
  coarse.tolerance = 1e-3, fine.tolerance = 1e-5;
  const SettingEstimate estimate = estimateOf({coarse, fine}, {&findMethod("dopri54"), 123, 1e-4});
  EXPECT_NEAR(estimate.error, 1e-4, kTolerance);
  EXPECT_NEAR(estimate.seconds, 0.1 * std::sqrt(2), kTolerance);
}

TEST(Frontier, HoldsTheRowsThatNoOtherBeatsInBoth) {
  std::vector<WorkRow> rows = someRows();
  rows.push_back(heldRow("leapfrog", 1e-3, 1, 1));  // worse than all
  const auto frontier = frontierOf(rows);
  ASSERT_EQ(frontier.size(), 4U);
  EXPECT_EQ(frontier.front()->integrator, "symplectic-euler");
  for (std::size_t k = 1; k < frontier.size(); ++k) {
    EXPECT_GT(frontier[k]->seconds, frontier[k - 1]->seconds);
    EXPECT_LT(frontier[k]->rmsError, frontier[k - 1]->rmsError);
  }
}

TEST(BetterRows, AreCheaperAtTheSameErrorOrCloserAtTheSameCost) {
  const std::vector<WorkRow> rows = someRows();
  const SettingEstimate euler = estimateOf(rows, {&findMethod("symplectic-euler"), 1e-3, 0});  // 1e-3 m for 0.01 s
  const BetterRows better = betterThan(rows, euler);
  EXPECT_EQ(better.cheaper, nullptr);  // rk4 reaches it at 0.01 s as well
  ASSERT_NE(better.closer, nullptr);
  EXPECT_EQ(better.closer->integrator, "rk4");
  EXPECT_EQ(better.closer->dt, 4e-3);
  std::vector<WorkRow> more = rows;
  more.push_back(heldRow("leapfrog", 4e-3, 1e-4, 2e-3));
  EXPECT_EQ(betterThan(more, euler).cheaper, &more.back());
}

TEST(BetterRows, AreNoneForTheFrontierItselfAndForWhatFails) {
  const std::vector<WorkRow> rows = someRows();
  EXPECT_EQ(betterThan(rows, rk4At(1e-3)).closer, nullptr);
  EXPECT_EQ(betterThan(rows, rk4At(1e-3)).cheaper, nullptr);
  EXPECT_EQ(betterThan(rows, rk4At(1)).cheaper, nullptr);
}

}  // namespace
}  // namespace tyg

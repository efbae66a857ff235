// What is compared past a horizon: sheets as wholes, against the spread of the reference's twin.
#include "study/work/past_horizon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "study/motion/reference.h"
#include "test_systems.h"
#include "tyg/methods.h"

namespace tyg::test {
namespace {

constexpr double kRounding = 1e-12;

PastHorizon run(Precision precision, double horizon, double centre, double band) {
  PastHorizon one;
  one.row.scene = "a,b", one.row.integrator = "rk4", one.row.precision = precision;
  one.row.horizon = horizon, one.row.dt = 0.5;
  one.distance = {centre, 1, 1}, one.band = {band, 2, 2};
  return one;
}

TEST(Bulk, OfFourParticlesIsTheirMeanAndTheSpreadAroundIt) {
  SampledMotion motion;
  motion.positions = {{{1, 0, 0}, {3, 0, 0}, {2, 1, 0}, {2, -1, 4}}};
  motion.energies = {7};
  const Bulk bulk = bulkOf(motion).at(0);
  EXPECT_EQ(bulk.centre, (Vec3{2, 0, 1}));
  EXPECT_NEAR(bulk.gyration, std::sqrt((2 + 2 + 2 + 10) / 4.0), kRounding);
  EXPECT_EQ(bulk.energy, 7);
}

TEST(Bulk, OfAFallingSheetFallsAndKeepsItsEnergy) {
  Scene scene = emptyWorld(3, 2);
  scene.gravity = {0, -10, 0};
  const std::vector<Bulk> bulk = bulkOf(sampledRun(scene, findMethod("rk4"), {0.5, 1}));
  ASSERT_EQ(bulk.size(), 2U);
  EXPECT_NEAR(bulk[1].centre.y - bulk[0].centre.y, -5 + 1.25, kRounding);
  EXPECT_NEAR(bulk[1].gyration, bulk[0].gyration, kRounding);
  EXPECT_NEAR(bulk[1].energy, 0, 1e-10);  // rounding of 300 J of fall
}

TEST(Bulk, DistancesAreTheLargestFromASampleOn) {
  const std::vector<Bulk> a{{{9, 0, 0}, 9, 9}, {{0, 0, 0}, 1, 1}, {{0, 0, 0}, 1, 4}};
  const std::vector<Bulk> b{{{0, 0, 0}, 0, 0}, {{0, 3, 4}, 3, 1}, {{0, 0, 1}, 1, 1}};
  const BulkDistance apart = bulkDistance(a, b, 1);
  EXPECT_EQ(apart.centre, 5);
  EXPECT_EQ(apart.gyration, 2);
  EXPECT_EQ(apart.energy, 3);
  EXPECT_TRUE(std::isnan(bulkDistance(a, std::span(b).first(2), 1).centre)) << "one of them ended early";
}

TEST(PastHorizon, IsToldInOneLineForEachPrecision) {
  const std::vector<std::string> lines = pastHorizonLines(
      {run(Precision::Float, 1, 0.25, 0.5), run(Precision::Float, 2, 0.75, 0.5), run(Precision::Double, 1, 3, 4)});
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_NE(lines[0].find("1 run goes in double past the horizon"), std::string::npos) << lines[0];
  EXPECT_NE(lines[1].find("centre of mass up to 0.75 m away (1 within the twin's 0.5 m)"), std::string::npos)
      << lines[1];
  EXPECT_NE(lines[1].find("gyration radius up to 1 m away (2 within the twin's 2 m)"), std::string::npos) << lines[1];
  EXPECT_TRUE(pastHorizonLines({}).empty());
}

TEST(PastHorizon, FileHasOneLineForEachRun) {
  const std::string csv = pastHorizonCsv({run(Precision::Float, 1, 0.25, 0.5)});
  EXPECT_EQ(csv,
            "scene,integrator,precision,dt,tolerance,horizon_s,centre_m,centre_band_m,gyration_m,gyration_band_m,"
            "energy_J,energy_band_J\n\"a,b\",rk4,float,0.5,0,1,0.25,0.5,1,2,1,2\n");
}

TEST(PastHorizon, HorizonsShorterThanTheRunAreToldFromTheFirstToTheLast) {
  std::vector<WorkRow> rows(4);
  for (WorkRow& row : rows) row.precision = Precision::Float, row.horizon = 3;
  EXPECT_TRUE(horizonLines(rows, 3).empty());
  rows[0].horizon = 0.5, rows[1].horizon = 2;
  rows[3].status = RowStatus::Unstable, rows[3].horizon = WorkRow::kNone;
  ASSERT_EQ(horizonLines(rows, 3).size(), 1U);
  EXPECT_EQ(horizonLines(rows, 3)[0], "2 of 3 runs in float from T* = 0.5 to 2 s of 3 s on");
  rows[0].horizon = rows[1].horizon = 0;
  EXPECT_EQ(horizonLines(rows, 3)[0], "2 of 3 runs in float from the start");
}

TEST(PastHorizon, TheBandIsTheTwinsSpreadAndWiderForRoundingLargerThanItsStart) {
  Reference reference;
  reference.size = 1;
  reference.motion.times = {1, 2, 3};
  reference.amplification = {1, 1, 2};
  reference.bulk = {{{0, 0, 0}, 1, 1}, {{0, 0, 0}, 1, 1}, {{0, 0, 0}, 1, 1}};
  reference.twinBulk = {{{9, 0, 0}, 1, 1}, {{1, 0, 0}, 1, 1}, {{3, 0, 0}, 1, 1}};
  EXPECT_EQ(reference.bandAfter(1, Precision::Double).centre, 3);
  EXPECT_NEAR(reference.bandAfter(1, Precision::Float).centre, 3 * std::ldexp(1e9, -24), 1e-6);
  reference.amplification.back() = 10 * Reference::kTwinLost;
  EXPECT_EQ(reference.bandAfter(1, Precision::Float).centre, 3) << "a lost twin spreads as far as anything does";
}

}  // namespace
}  // namespace tyg::test

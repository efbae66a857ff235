// Rows as CSV and back, and the cheapest of them.
#include "study/work/work_rows.h"

#include <gtest/gtest.h>

#include <cmath>

#include "study/work/frontier.h"

namespace tyg {
namespace {

constexpr const char* kHeader =
    "scene,columns,rows,integrator,precision,dt,tolerance,steps,force_evaluations,seconds,rms_error_m,max_error_m,"
    "energy_drift,floor_m,horizon_s,status,device\n";

WorkRow someRow(const std::string& integrator, double error, double seconds, std::int64_t evaluations) {
  WorkRow row;
  row.scene = "curtain", row.columns = 20, row.rows = 30;
  row.integrator = integrator;
  row.dt = 1.0 / 3, row.steps = 6, row.forceEvaluations = evaluations;
  row.seconds = seconds, row.rmsError = error, row.maxError = 2 * error, row.energyDrift = 0.1;
  row.floor = 1e-14, row.horizon = 2;
  return row;
}

TEST(WorkRows, HaveTheHeaderThatScriptsRelyOn) { EXPECT_EQ(workCsv({}), kHeader); }

TEST(WorkRows, AreReadBackAsTheyWereWritten) {
  std::vector<WorkRow> rows{someRow("rk4", 1e-3 / 3, 0.1, 24), someRow("bs32", 1e-300, 1e22, 1'000'000'000'000)};
  rows[0].scene = "a folder, with \"quotes\"/x.toml";
  rows[1].precision = Precision::Float, rows[1].tolerance = 1e-7, rows[1].device = RowDevice::Gpu;
  const std::vector<WorkRow> read = parseWorkCsv(workCsv(rows), "rows.csv");
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].scene, rows[0].scene);
  EXPECT_EQ(read[0].rmsError, rows[0].rmsError);
  EXPECT_EQ(read[1].precision, Precision::Float);
  EXPECT_EQ(read[0].device, RowDevice::Cpu);
  EXPECT_EQ(read[1].device, RowDevice::Gpu);
  EXPECT_EQ(workCsv(read), workCsv(rows));
}

TEST(WorkRows, FromBeforeThereWasADeviceAreOfTheProcessor) {
  const std::string old =
      "scene,columns,rows,integrator,precision,dt,tolerance,steps,force_evaluations,seconds,rms_error_m,max_error_m,"
      "energy_drift,floor_m,horizon_s,status\ncurtain,20,20,rk4,float,0.001,0,6,24,0.1,0.01,0.02,0,0,1,ok\n";
  const std::vector<WorkRow> read = parseWorkCsv(old, "rows.csv");
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].device, RowDevice::Cpu);
  EXPECT_EQ(read[0].integrator, "rk4");
}

TEST(WorkRows, OfFailedRunsKeepTheirStatusAndHaveNoError) {
  WorkRow row;
  row.scene = "x", row.integrator = "rk4";
  for (const RowStatus status : {RowStatus::Unstable, RowStatus::NotFinite, RowStatus::TooSlow}) {
    row.status = status;
    const std::string csv = workCsv({row});
    EXPECT_NE(csv.find("," + std::string(nameOf(status)) + ",cpu\n"), std::string::npos);
    const WorkRow read = parseWorkCsv(csv, "rows.csv").at(0);
    EXPECT_EQ(read.status, status);
    EXPECT_TRUE(std::isnan(read.rmsError));
    EXPECT_FALSE(read.trusted(0));
  }
}

TEST(WorkRows, OfRunsThatHeldHaveFiniteNumbers) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  for (const double wrong : {kInfinite, -1.0, std::nan("")}) {
    for (double WorkRow::*number : {&WorkRow::dt, &WorkRow::tolerance, &WorkRow::seconds, &WorkRow::rmsError}) {
      WorkRow row = someRow("rk4", 1e-3, 0.1, 24);
      row.*number = wrong;
      EXPECT_THROW(parseWorkCsv(workCsv({row}), "old.csv"), InputError) << workCsv({row});
    }
  }
}

TEST(WorkRows, OfAnotherFileAreRefusedByLine) {
  const std::string good = workCsv({someRow("rk4", 1e-3, 0.1, 24)});
  const auto refusal = [](const std::string& text) -> std::string {
    try {
      parseWorkCsv(text, "old.csv");
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_EQ(refusal(good), "");
  EXPECT_NE(refusal("").find("old.csv"), std::string::npos);
  EXPECT_NE(refusal("t,x\n1,2\n").find("old.csv:1"), std::string::npos);
  EXPECT_NE(refusal(good + "curtain,20\n").find("old.csv:3"), std::string::npos);
  std::string wrong = good;
  wrong.replace(wrong.find(",ok"), 3, ",fine");
  EXPECT_NE(refusal(wrong).find("old.csv:2: found 'fine'"), std::string::npos);
}

TEST(Prices, AreTheCheapestRowsOfEachMethodWhoseErrorAndFloorAreWithinTheError) {
  std::vector<WorkRow> rows{someRow("rk4", 1e-3, 0.5, 10), someRow("rk4", 1e-4, 0.7, 20),
                            someRow("leapfrog", 5e-3, 0.1, 5), someRow("bs32", 1e-3, 0.2, 30),
                            someRow("xpbd", 1e-6, 0.01, 0)};
  rows[4].floor = 3e-3;  // may be as wrong as that
  const std::vector<Price> prices = pricesOf(rows, 2e-3, Cost::Seconds);
  ASSERT_EQ(prices.size(), 2U);
  EXPECT_EQ(prices[0].integrator, "bs32");
  EXPECT_EQ(prices[1].integrator, "rk4");
  EXPECT_EQ(prices[1].cost, 0.5);
  EXPECT_EQ(pricesOf(rows, 2e-3, Cost::Evaluations)[0].integrator, "rk4");
}

}  // namespace
}  // namespace tyg

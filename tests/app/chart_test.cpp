// `tyg chart`: its files, what it refuses, and what is left when it is interrupted.
#include "app/program.h"

namespace tyg {
namespace {

// A small sheet and coarse errors: enough for every part of the work.
const std::string kSmall = "chart curtain --quick --sheet 4x4 --duration 0.5 --error-range 1e-5:1 --methods leapfrog";
constexpr const char* kWithoutGnuplot = "PATH=/nowhere";  // drawing takes longer than all the rest

TEST(Chart, WritesRowsScriptAndPictures) {
  const Folder folder;
  const Outcome outcome = tyg(kSmall + ",rk4 --out " + (folder / "made/here").string());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const std::string rows = contentsOf(folder / "made/here/rows.csv");
  EXPECT_EQ(rows.rfind("scene,columns,rows,integrator,precision,dt,tolerance,steps,force_evaluations,seconds,"
                       "rms_error_m,max_error_m,energy_drift,floor_m,horizon_s,status,device\n",
                       0),
            0U);
  for (const char* part : {"curtain,4,4,leapfrog,double,", "curtain,4,4,rk4,float,", ",unstable,cpu\n", ",ok,cpu\n"}) {
    EXPECT_TRUE(holds(rows, part)) << part;
  }
  EXPECT_EQ(contentsOf(folder / "made/here/chart.png").substr(0, 4), "\x89PNG");
  EXPECT_TRUE(holds(contentsOf(folder / "made/here/chart.svg"), "leapfrog"));
  EXPECT_TRUE(holds(outcome.out, "cheapest")) << outcome.out;
}

TEST(Chart, WithoutGnuplotRowsAndScriptAreWrittenAllTheSame) {
  const Folder folder;
  const Outcome outcome = tyg(kSmall + " --out " + (folder / "").string(), kWithoutGnuplot);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(holds(outcome.out, "gnuplot chart.gp")) << outcome.out;
  EXPECT_TRUE(std::filesystem::exists(folder / "rows.csv"));
  EXPECT_FALSE(std::filesystem::exists(folder / "chart.png"));
}

TEST(Chart, ComparesWithAnEarlierFileOfTheSameScene) {
  const Folder folder;
  const std::string out = " --out " + (folder / "").string();
  ASSERT_EQ(tyg(kSmall + out, kWithoutGnuplot).code, 0);
  const std::string rows = (folder / "rows.csv").string();
  const Outcome same = tyg(kSmall + " --compare " + rows + out, kWithoutGnuplot);
  EXPECT_EQ(same.code, 0) << same.err;
  EXPECT_TRUE(holds(same.out, "times the seconds of before")) << same.out;
  EXPECT_TRUE(holds(contentsOf(folder / "chart.gp"), "compare.csv"));
  const Outcome other = tyg("chart stiff --quick --sheet 4x4 --compare " + rows + out, kWithoutGnuplot);
  EXPECT_EQ(other.code, 2);
  EXPECT_TRUE(holds(other.err, "'stiff' of 4x4")) << other.err;
}

TEST(Chart, FinerSheetsBecomeALineAndAFile) {
  const Folder folder;
  const Outcome outcome = tyg(kSmall + " --sheets 7x7,13x13 --out " + (folder / "").string(), kWithoutGnuplot);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(linesOf(folder / "sheets.csv"), 3U);
  EXPECT_TRUE(holds(contentsOf(folder / "chart.gp"), "13x13"));
}

TEST(Chart, TheHorizonShortensEveryRun) {
  const Folder folder;
  ASSERT_EQ(tyg(kSmall + " --horizon 0.1 --out " + (folder / "").string(), kWithoutGnuplot).code, 0);
  EXPECT_TRUE(holds(contentsOf(folder / "chart.gp"), "duration = 0.10000000000000001 "));
}

TEST(Chart, AnErrorRangeAndAPrecisionNarrowItDownAndOldFilesGo) {
  const Folder folder;
  folder.write("past_horizon.csv", "of an earlier chart");
  const Outcome outcome = tyg(kSmall + " --precision double --out " + (folder / "").string(), kWithoutGnuplot);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_FALSE(holds(contentsOf(folder / "rows.csv"), ",float,"));
  EXPECT_TRUE(holds(contentsOf(folder / "chart.gp"), "set yrange [1e-05:"));
  EXPECT_FALSE(std::filesystem::exists(folder / "past_horizon.csv")) << "no run came near its floor";
}

TEST(Chart, AMethodThatCannotTakeTheSceneIsLeftOutAndSaysSo) {
  const Folder folder;
  const std::string scene = folder
                                .write("axial.toml", R"(
title = "Axial"
[sheet]
columns = 2
rows = 2
spacing = 0.5
particle_mass = 0.1
pins = ["top-left"]
[springs]
damping = "axial"
structural = { ks = 100, kd = 0.1 }
[run]
duration = 0.2
integrator = "rk4"
dt = 0.01
)")
                                .string();
  const Outcome outcome =
      tyg("chart " + scene + " --quick --methods imex,leapfrog --error-range 1e-3:1 --out " + (folder / "").string(),
          kWithoutGnuplot);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(holds(outcome.err, "left out: imex: found")) << outcome.err;
  EXPECT_FALSE(holds(contentsOf(folder / "rows.csv"), ",imex,"));
}

TEST(Chart, WhatIsPastTheHorizonIsToldAndComparedInAFileOfItsOwn) {
  const Folder folder;
  // A chain stands on its pin: it falls to a side that rounding decides.
  const std::string scene = folder
                                .write("upright.toml", R"(
title = "Upright"
[sheet]
columns = 1
rows = 3
spacing = 0.5
particle_mass = 0.1
pins = ["bottom-left"]
[springs]
structural = { ks = 1000, kd = 0.1 }
bend = { ks = 10, kd = 0.1 }
[run]
duration = 2
integrator = "rk4"
dt = 0.01
)")
                                .string();
  const std::string command = "chart " + scene + " --quick --methods rk4 --out " + (folder / "out").string();
  const Outcome far = tyg(command, kWithoutGnuplot);
  EXPECT_EQ(far.code, 0) << far.err;
  EXPECT_TRUE(holds(far.out, "in float past the horizon")) << far.out;
  EXPECT_TRUE(holds(contentsOf(folder / "out/chart.gp"), "runs in float from ")) << far.out;
  EXPECT_GT(linesOf(folder / "out/past_horizon.csv"), 1U);
}

TEST(Chart, AnInterruptKeepsTheRowsSoFar) {
  const Folder folder;
  folder.write("rows.csv", "an earlier chart");
  Outcome outcome;
  for (const char* seconds : {"1.5", "6", "24"}) {  // of about 60: when a busy machine has some rows, not all
    outcome = tyg("chart curtain --sheet 3x3 --duration 0.05 --out " + (folder / "").string(),
                  std::string("timeout --foreground --preserve-status --signal INT ") + seconds);
    ASSERT_EQ(outcome.code, 130) << outcome.err;
    if (holds(outcome.err, "rows so far")) break;
  }
  EXPECT_TRUE(holds(outcome.err, "rows so far")) << outcome.err;
  EXPECT_GT(linesOf(folder / "interrupted/rows.csv"), 1U);
  EXPECT_TRUE(std::filesystem::exists(folder / "interrupted/chart.gp"));
  EXPECT_FALSE(std::filesystem::exists(folder / "interrupted/chart.png"));
  EXPECT_EQ(contentsOf(folder / "rows.csv"), "an earlier chart");
}

TEST(Chart, WrongOptionsAreRefused) {
  for (const char* wrong :
       {"--methods euler", "--methods ,", "--error-range 1", "--error-range 1:1e-3", "--error-range 0:1",
        "--horizon -1", "--sheets 40x40", "--sheets big", "--compare nothing.csv"}) {
    const Outcome outcome = tyg(std::string("chart curtain ") + wrong);
    EXPECT_EQ(outcome.code, 2) << wrong;
    EXPECT_TRUE(holds(outcome.err, "llowed")) << outcome.err;
  }
}

TEST(Chart, AFolderThatCannotBeMadeIsRefusedBeforeAnythingIsComputed) {
  const Folder folder;
  const std::string file = folder.write("file", "").string();
  const Outcome outcome = tyg("chart curtain --sheet 500x500 --out " + file + "/below");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(holds(outcome.err, file)) << outcome.err;
}

}  // namespace
}  // namespace tyg

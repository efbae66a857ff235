// `tyg chart`: its files, what it refuses, and what is left when it is interrupted.
#include "app/program.h"

namespace tyg {
namespace {

// A small sheet: enough for every part of the work.
const std::string kSmall = "chart curtain --quick --sheet 4x4 --methods leapfrog,rk4 ";

TEST(Chart, WritesRowsScriptAndPictures) {
  const Folder folder;
  const Outcome outcome = tyg(kSmall + "--out " + (folder / "made/here").string());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const std::string rows = contentsOf(folder / "made/here/rows.csv");
  EXPECT_EQ(rows.rfind("scene,columns,rows,integrator,precision,dt,tolerance,steps,force_evaluations,seconds,"
                       "rms_error_m,max_error_m,energy_drift,floor_m,horizon_s,status\n",
                       0),
            0U);
  for (const char* part : {"curtain,4,4,leapfrog,double,", "curtain,4,4,rk4,float,", ",unstable\n", ",ok\n"}) {
    EXPECT_TRUE(holds(rows, part)) << part;
  }
  EXPECT_EQ(contentsOf(folder / "made/here/chart.png").substr(0, 4), "\x89PNG");
  EXPECT_TRUE(holds(contentsOf(folder / "made/here/chart.svg"), "leapfrog"));
  EXPECT_TRUE(holds(outcome.out, "cheapest")) << outcome.out;
}

TEST(Chart, WithoutGnuplotRowsAndScriptAreWrittenAllTheSame) {
  const Folder folder;
  const Outcome outcome = tyg(kSmall + "--out " + (folder / "").string(), "PATH=/nowhere");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(holds(outcome.out, "gnuplot chart.gp")) << outcome.out;
  EXPECT_EQ(folder.fileCount(), 2U);
}

TEST(Chart, ComparesWithAnEarlierFileOfTheSameScene) {
  const Folder folder;
  const std::string out = " --out " + (folder / "").string();
  ASSERT_EQ(tyg(kSmall + out).code, 0);
  const std::string rows = (folder / "rows.csv").string();
  const Outcome same = tyg(kSmall + "--compare " + rows + out);
  EXPECT_EQ(same.code, 0) << same.err;
  EXPECT_TRUE(holds(same.out, "times the seconds of before")) << same.out;
  EXPECT_TRUE(holds(contentsOf(folder / "chart.gp"), "compare.csv"));
  const Outcome other = tyg("chart stiff --quick --sheet 4x4 --compare " + rows + out);
  EXPECT_EQ(other.code, 2);
  EXPECT_TRUE(holds(other.err, "'stiff' of 4x4")) << other.err;
}

TEST(Chart, FinerSheetsBecomeALineAndAFile) {
  const Folder folder;
  const Outcome outcome = tyg(kSmall + "--sheets 7x7,13x13 --out " + (folder / "").string());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(linesOf(folder / "sheets.csv"), 3U);
  EXPECT_TRUE(holds(contentsOf(folder / "chart.gp"), "13x13"));
}

TEST(Chart, TheHorizonShortensEveryRun) {
  const Folder folder;
  ASSERT_EQ(tyg(kSmall + "--horizon 0.1 --out " + (folder / "").string()).code, 0);
  EXPECT_TRUE(holds(contentsOf(folder / "chart.gp"), "duration = 0.1 "));
}

TEST(Chart, AnInterruptKeepsTheRowsSoFar) {
  const Folder folder;
  const Outcome outcome = tyg("chart curtain --sheet 3x3 --duration 0.2 --out " + (folder / "").string(),
                              "timeout --preserve-status --signal INT 15");  // of about 70: some rows, not all
  EXPECT_EQ(outcome.code, 130) << outcome.err;
  EXPECT_TRUE(holds(outcome.err, "rows so far")) << outcome.err;
  EXPECT_GT(linesOf(folder / "rows.csv"), 2U);
  EXPECT_EQ(folder.fileCount(), 2U);
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

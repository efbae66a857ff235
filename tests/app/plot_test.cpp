// `tyg plot`: rows, script and pictures, and what happens without gnuplot.
#include "app/program.h"

namespace tyg {
namespace {

constexpr const char* kPng = "\x89PNG";

TEST(Plot, WritesRowsScriptAndPictures) {
  const Folder folder;
  const Outcome outcome = tyg("plot four-particles --duration 0.5 --out " + (folder / "made/here").string());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  for (const char* file : {"plot.csv", "plot.gp", "plot.svg", "plot.png"}) {
    EXPECT_TRUE(holds(outcome.out, file));
    EXPECT_GT(contentsOf(folder / "made/here" / file).size(), 500U) << file;
  }
  EXPECT_EQ(contentsOf(folder / "made/here/plot.png").substr(0, 4), kPng);
  EXPECT_TRUE(holds(contentsOf(folder / "made/here/plot.svg"), "</svg>"));
}

TEST(Plot, ComparesTheReportsTwoMethodsWithTheTrueRungeKuttaByDefault) {
  const Folder folder;
  ASSERT_EQ(tyg("plot four-particles --duration 0.2 --out " + (folder / "").string()).code, 0);
  const std::string rows = contentsOf(folder / "plot.csv");
  for (const char* start :
       {"\nsymplectic-euler,bottom-left,0,", "\nreport-rk4,bottom-left,0,", "\nrk4,bottom-left,0,"}) {
    EXPECT_TRUE(holds(rows, start)) << start;
  }
}

TEST(Plot, TheFourParticlesStayInTheirPlane) {
  const Folder folder;
  ASSERT_EQ(tyg("plot four-particles --out " + (folder / "").string()).code, 0);
  EXPECT_TRUE(holds(contentsOf(folder / "plot.gp"), "z does not change"));
}

TEST(Plot, ChosenParticlesAndMethodsAreDrawn) {
  const Folder folder;
  const Outcome outcome =
      tyg("plot curtain --duration 0.1 --particles middle,0:19 --methods leapfrog,rk4 --out " + (folder / "").string());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const std::string rows = contentsOf(folder / "plot.csv");
  for (const char* start : {"\nleapfrog,middle,", "\nleapfrog,0:19,", "\nrk4,middle,", "\nrk4,0:19,"}) {
    EXPECT_TRUE(holds(rows, start)) << start;
  }
}

TEST(Plot, AFailedRunStaysInTheChart) {
  const Folder folder;
  const Outcome outcome = tyg("plot curtain --methods leapfrog,rk4 --dt 0.0035 --out " + (folder / "").string());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(holds(outcome.err, "leapfrog")) << outcome.err;
  EXPECT_TRUE(holds(contentsOf(folder / "plot.csv"), "unstable"));
  EXPECT_TRUE(holds(contentsOf(folder / "plot.gp"), "Leapfrog (unstable at"));
}

TEST(Plot, WithoutGnuplotRowsAndScriptAreWrittenAllTheSame) {
  const Folder folder;
  const Outcome outcome = tyg("plot spring --duration 0.5 --out " + (folder / "").string(), "PATH=/nowhere");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(holds(outcome.out, "gnuplot is not installed")) << outcome.out;
  EXPECT_EQ(folder.fileCount(), 2U);
}

TEST(Plot, WrongNamesAreRefused) {
  for (const char* wrong :
       {"--particles nowhere", "--particles 99:0", "--particles ,", "--methods euler", "--methods ,"}) {
    const Outcome outcome = tyg(std::string("plot curtain ") + wrong);
    EXPECT_EQ(outcome.code, 2) << wrong;
    EXPECT_FALSE(outcome.err.empty()) << wrong;
  }
}

TEST(Plot, AFolderThatCannotBeMadeIsRefusedBeforeAnythingIsComputed) {
  const Folder folder;
  const std::string file = folder.write("file", "").string();
  const Outcome outcome = tyg("plot curtain --dt 1e-8 --duration 1000 --out " + file + "/below");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(holds(outcome.err, file)) << outcome.err;
}

}  // namespace
}  // namespace tyg

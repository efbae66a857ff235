// `tyg stability`: its table and files, what it refuses, and what it leaves when interrupted.
#include "app/program.h"

namespace tyg {
namespace {

const std::string kSmall = "stability curtain --sheet 5x5 --duration 0.2 --methods leapfrog,xpbd ";

TEST(Stability, PrintsATableAndWritesRowsScriptAndPictures) {
  const Folder folder;
  const Outcome outcome = tyg(kSmall + "--out " + (folder / "made").string());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  for (const char* part : {"leapfrog          scene", "leapfrog          none", "xpbd has no limit", "stability.png"}) {
    EXPECT_TRUE(holds(outcome.out, part)) << part << " is not in\n" << outcome.out;
  }
  const std::string csv = contentsOf(folder / "made/stability.csv");
  EXPECT_EQ(csv.rfind("scene,integrator,damping,predicted_dt,certified_dt,measured_dt,first_mode\n", 0), 0U);
  EXPECT_EQ(contentsOf(folder / "made/stability.png").substr(0, 4), "\x89PNG");
  EXPECT_TRUE(holds(contentsOf(folder / "made/stability.svg"), "leapfrog"));
}

TEST(Stability, WithoutGnuplotRowsAndScriptAreWrittenAllTheSame) {
  const Folder folder;
  const Outcome outcome = tyg(kSmall + "--out " + (folder / "").string(), "PATH=/nowhere");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(holds(outcome.out, "gnuplot stability.gp")) << outcome.out;
  EXPECT_TRUE(std::filesystem::exists(folder / "stability.csv"));
  EXPECT_FALSE(std::filesystem::exists(folder / "stability.png"));
}

TEST(Stability, RefusesUnknownMethodsAndFoldersThatCannotBeMade) {
  const Outcome method = tyg("stability curtain --methods euler");
  EXPECT_EQ(method.code, 2);
  EXPECT_TRUE(holds(method.err, "symplectic-euler")) << method.err;
  const Outcome none = tyg("stability curtain --methods ,");
  EXPECT_EQ(none.code, 2);
  const Folder folder;
  const std::string file = folder.write("file", "").string();
  EXPECT_EQ(tyg(kSmall + "--out " + file).code, 2);
}

TEST(Stability, InterruptedWritesNothing) {
  const Folder folder;
  // All methods on a sheet of this size take minutes.
  const Outcome outcome = tyg("stability curtain --sheet 60x60 --out " + (folder / "").string(),
                              "timeout --foreground --preserve-status --signal INT 1.5");
  EXPECT_EQ(outcome.code, 130) << outcome.err;
  EXPECT_TRUE(holds(outcome.err, "nothing was written")) << outcome.err;
  EXPECT_EQ(folder.fileCount(), 0U);
}

}  // namespace
}  // namespace tyg

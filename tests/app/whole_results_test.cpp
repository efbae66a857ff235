// What commands leave where programs that draw for them fail without a word, where files cannot be written, and where
// standard files are closed.
#include <filesystem>

#include "app/program.h"

namespace tyg {
namespace {

namespace fs = std::filesystem;

class WholeResults : public testing::Test {
 protected:
  /// A program of this name that runs a script of the shell.
  void pretend(const std::string& program, const std::string& script) {
    fs::permissions(bin_.write(program, "#!/bin/sh\n" + script), fs::perms::owner_all);
  }
  Outcome run(const std::string& command) {
    return tyg(command, "cd '" + folder_.path().string() + "' && PATH='" + bin_.path().string() + "':\"$PATH\"");
  }
  const Folder bin_, folder_;
};

TEST_F(WholeResults, AGnuplotThatDrawsNothingAndExitsWithZeroReplacesNoPicture) {
  pretend("gnuplot", "exit 0\n");
  for (const char* command : {"plot spring --duration 0.1 --out .", "stability spring --methods leapfrog --out .",
                              "chart spring --quick --methods leapfrog --duration 0.1 --out ."}) {
    const std::string stem = std::string(command).substr(0, std::string(command).find(' '));
    folder_.write(stem + ".svg", "a good one"), folder_.write(stem + ".png", "a good one");
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.code, 2) << command;
    EXPECT_TRUE(holds(outcome.err, "unfinished")) << outcome.err;
    EXPECT_EQ(contentsOf(folder_ / (stem + ".svg")) + contentsOf(folder_ / (stem + ".png")), "a good onea good one");
  }
}

TEST_F(WholeResults, AFfmpegThatWritesHalfAMovieAndExitsWithZeroReplacesNoMovie) {
  pretend("ffmpeg", "for file; do :; done; cat >/dev/null; echo half >\"${file#file:}\"\n");
  folder_.write("a.mp4", "a good one");
  const Outcome outcome = run("render spring --from 0 --to 0.2 --size 64x48 --out a.mp4");
  EXPECT_EQ(outcome.code, 2) << outcome.out;
  EXPECT_EQ(contentsOf(folder_ / "a.mp4"), "a good one");
  EXPECT_EQ(folder_.fileCount(), 1U);
}

TEST_F(WholeResults, AnInterruptEndsAProgramThatHangs) {
  pretend("gnuplot", "kill -INT $PPID\nexec sleep 100\n");
  pretend("ffmpeg", "kill -TERM $PPID\nexec sleep 100\n");
  for (const char* command : {"plot spring --duration 0.1 --out .", "render spring --to 20 --out a.mp4"}) {
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.code, 130) << outcome.err;
    EXPECT_TRUE(holds(outcome.err, "interrupted")) << outcome.err;
    EXPECT_FALSE(fs::exists(folder_ / "plot.svg") || fs::exists(folder_ / "a.mp4"));
  }
}

TEST_F(WholeResults, AnInterruptAndAFailureLeaveNoEmptyFolder) {
  pretend("interrupted", "timeout --foreground -s INT 0.5 \"$@\"\n");
  for (const std::string command : {"chart curtain --duration 1000 --out a/b", "stability curtain --out a/b",
                                    "diet curtain --duration 1000 --out a/b", "plot curtain --duration 1000 --out a/b",
                                    "render curtain --to 1000 --fps 1 --out a/b"}) {
    const Outcome outcome =
        tyg(command, "cd '" + folder_.path().string() + "' && '" + (bin_ / "interrupted").string() + "'");
    EXPECT_TRUE(outcome.code == 130 || outcome.code == 124) << command << outcome.err;
    EXPECT_EQ(folder_.fileCount(), 0U) << command;
  }
  EXPECT_EQ(run("render curtain --dt 1 --out a").code, 1);
  EXPECT_EQ(run("plot spring --duration 0.1 --out a/b").code, 0);
  EXPECT_TRUE(fs::exists(folder_ / "a/b/plot.csv"));
  EXPECT_EQ(folder_.fileCount(), 1U);
}

TEST_F(WholeResults, PicturesGoWhereLinksLead) {
  const Folder elsewhere;
  fs::create_symlink(elsewhere / "real.svg", folder_ / "plot.svg");
  EXPECT_EQ(run("plot spring --duration 0.1 --out .").code, 0);
  EXPECT_TRUE(fs::is_symlink(folder_ / "plot.svg"));
  EXPECT_TRUE(holds(contentsOf(elsewhere / "real.svg"), "</svg>"));
}

TEST_F(WholeResults, PathsThatCannotBeUsedAreWrongInputWhateverTheCommand) {
  fs::create_symlink("second", folder_ / "first");
  fs::create_symlink("first", folder_ / "second");
  const std::string tooLong(300, 'x');
  for (const std::string& path : {std::string("first/a"), tooLong + "/a"}) {
    for (const std::string command :
         {"run spring --out ", "render spring --out ", "plot spring --out ", "stability spring --out ",
          "chart spring --out ", "diet spring --out ", "view spring --record ", "advise spring --error 1mm --write ",
          "run ", "run --replay ", "chart spring --compare ", ""}) {
      const Outcome outcome = run(command + path);
      EXPECT_EQ(outcome.code, 2) << command << path << outcome.err;
      EXPECT_TRUE(holds(outcome.err, "allowed") || holds(outcome.err, "neither a command")) << outcome.err;
    }
  }
  EXPECT_EQ(run("run spring --out first").code, 2);
  EXPECT_TRUE(fs::is_symlink(folder_ / "first"));
}

/// Each of them fails at once after it has said so.
TEST_F(WholeResults, AreAnnouncedWithTheirSizeWhereThatIsAGigabyteOrMore) {
  const std::string past = " curtain --integrator rk4 --dt 1 --duration 1e7 --out ";
  for (const auto& [command, size] :
       {std::pair{"run" + past + "a.csv --samples 100000", "a.csv will take about 5.6 GB"},
        {"export" + past + "a.usda --fps 0.01", "a.usda will take about 2.8 GB"},
        {"export" + past + "frames --fps 0.01", "frames will take about 5.2 GB"},
        {"reference" + past + "a.csv --samples 100000", "a.csv will take about 3.1 GB"}}) {
    const Outcome outcome = run(command);
    EXPECT_NE(outcome.code, 0);
    EXPECT_TRUE(holds(outcome.err, size)) << command << outcome.err;
  }
  EXPECT_FALSE(holds(run("run spring --duration 0.1 --out a.csv").err, "will take"));
}

TEST_F(WholeResults, NoMessageGetsIntoAFileWhereStandardFilesAreClosed) {
  for (const std::string closed : {"2>&-", ">&-", "<&- >&- 2>&-"}) {
    const std::string command = "cd '" + folder_.path().string() +
                                "' && '" TYG_PROGRAM "' run spring --duration 0.1 --verbose --out a.csv " + closed;
    const int status = std::system(command.c_str());
    EXPECT_EQ(WEXITSTATUS(status), holds(closed, ">&- ") || closed == ">&-" ? 2 : 0) << closed;
    const std::string rows = contentsOf(folder_ / "a.csv");
    EXPECT_EQ(rows.substr(0, 10), "t,particle") << closed;
    EXPECT_FALSE(holds(rows, "spring")) << closed;
  }
}

TEST_F(WholeResults, AReaderThatLeavesEarlyLeavesNoTemporaryFile) {
  const std::string command =
      "cd '" + folder_.path().string() + "' && '" TYG_PROGRAM "' run spring --duration 0.1 --out a.csv | true";
  (void)std::system(command.c_str());
  EXPECT_LE(folder_.fileCount(), 1U);
}

}  // namespace
}  // namespace tyg

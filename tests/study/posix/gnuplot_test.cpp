// gnuplot as a child process: drawn, failed or missing, each told apart.
#include "study/charts/gnuplot.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <set>

#include "files.h"
#include "util/interrupt.h"

namespace tyg {
namespace {

using Kind = GnuplotOutcome::Kind;

class Gnuplot : public testing::Test {
 protected:
  GnuplotOutcome run(const std::string& script, const std::vector<std::string>& definitions = {}) {
    folder_.write("a.gp", script);
    return runGnuplot(folder_.path(), "a.gp", definitions);
  }
  const Folder folder_;
};

TEST_F(Gnuplot, DrawsInItsFolderWithTheDefinitionsGiven) {
  const GnuplotOutcome outcome =
      run("set terminal svg\nset output name\nplot sin(x)\nunset output\n", {"name=" + gnuplotQuoted("it's.svg")});
  EXPECT_EQ(outcome.kind, Kind::Drawn) << outcome.message;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "it's.svg"));
}

TEST_F(Gnuplot, AnyBytesInQuotesAreThatTextAndNothingElse) {
  const std::string active = "#'\"`touch owned`$(touch owned)\\\n@x\\07 7{/*9 y}%d\xC3\xA9\xFF\x1B";
  const GnuplotOutcome outcome =
      run("do for [k in 'a b'] {\n  x = 1\n  print " + gnuplotQuoted(active) + "\n}\nprint given\n",
          {"given=" + gnuplotQuoted(active)});
  EXPECT_EQ(outcome.message, active + "\n" + active + "\n" + active + "\n");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "owned"));
}

TEST_F(Gnuplot, AScriptWithAMistakeFailsWithWhatGnuplotSaid) {
  const GnuplotOutcome outcome = run("plot nothing_of_that_name\n");
  EXPECT_EQ(outcome.kind, Kind::Failed);
  EXPECT_NE(outcome.message.find("nothing_of_that_name"), std::string::npos) << outcome.message;
}

TEST_F(Gnuplot, WithoutGnuplotItIsMissing) {
  const std::string path = std::getenv("PATH");
  setenv("PATH", folder_.path().c_str(), 1);
  const GnuplotOutcome outcome = run("plot sin(x)\n");
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(outcome.kind, Kind::Missing);
}

TEST_F(Gnuplot, AnInterruptEndsIt) {
  const InterruptWatch watch;
  std::raise(SIGINT);
  EXPECT_EQ(run("pause 1000\n").kind, Kind::Failed);
}

TEST(ChartColour, SevenColoursAreDifferent) {
  std::set<std::string> colours;
  for (std::size_t k = 0; k < 7; ++k) colours.insert(chartColour(k));
  EXPECT_EQ(colours.size(), 7U);
  EXPECT_EQ(chartColour(7), chartColour(0));
}

}  // namespace
}  // namespace tyg

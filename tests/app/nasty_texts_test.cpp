// Titles and file names that try to be commands, markup or escapes: nothing is run, pictures are XML, what is written
// can be read again, and nothing steers the terminal.
#include <array>
#include <cctype>
#include <filesystem>

#include "app/program.h"

namespace tyg {
namespace {

namespace fs = std::filesystem;

/// Each as the text of a TOML string between three quotes. One that gets out makes a file `owned`.
constexpr std::array kTitles{
    R"(Silk
system("touch owned")
x = \")",
    R"('"; system("touch owned") #)",
    "'a title that begins with a quote",
    "# a title that begins with a hash",
    "`touch owned` $(touch owned) @x {/*9 y} a_b^c %d \\\\042 ~",
    "a\\u001B[31mred\\u009B31m\\u0007\\u007F \\u0000 \\uFFFF \\uFFFE \\uFDD0 \\u202E \\u2028",
    "</text><script>x</script>]]> & &foo; &#7; <!-- -->",
    "'7#1\\\\7 \\\\",
};
constexpr std::array kFileNames{
    "#a",        "-b",     "'c",    "d\nsystem(\"touch owned\")\nx = \"", "`touch owned`$(touch owned)", "e\xFF",
    "f\x1B[31m", "g;h &|", "i\"j\\"};

constexpr const char* kSheet =
    "\n[sheet]\ncolumns = 2\nrows = 2\nspacing = 0.5\nparticle_mass = 0.1\npins = [\"top-left\"]\n"
    "[springs]\nstructural = { ks = 100, kd = 0.1 }\n[run]\nduration = 0.05\nintegrator = \"leapfrog\"\ndt = 0.001\n";

std::string sceneTitled(const std::string& title) { return "title = \"\"\"" + title + "\"\"\"" + kSheet; }

std::string inQuotes(const std::string& word) {
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

bool hasActive(const std::string& text) {
  for (const unsigned char c : text) {
    if ((c < 0x20 && c != '\n' && c != '\t') || c == 0x7F) return true;
  }
  return holds(text, "\xC2\x9B") || holds(text, "\xE2\x80\xAE") || holds(text, "\xFF");
}

class NastyTexts : public testing::Test {
 protected:
  /// Runs a command in the folder, and looks at what it said and left there.
  Outcome run(const std::string& command) {
    const Outcome outcome = tyg(command, "cd " + inQuotes(folder_.path().string()) + " &&");
    EXPECT_FALSE(hasActive(outcome.out)) << command << "\n" << outcome.out;
    EXPECT_FALSE(hasActive(outcome.err)) << command << "\n" << outcome.err;
    for (const fs::path& folder : {folder_.path(), folder_ / "out"}) {
      EXPECT_FALSE(fs::exists(folder / "owned")) << command;
    }
    return outcome;
  }
  void expectXml(const std::string& file) {
    const std::string path = (folder_ / file).string();
    EXPECT_EQ(std::system(("python3 -c 'import sys, xml.dom.minidom as m; m.parse(sys.argv[1])' " + path).c_str()), 0)
        << contentsOf(path);
  }
  const Folder folder_;
};

TEST_F(NastyTexts, TitlesAreDrawnAsTheyAre) {
  for (const char* title : kTitles) {
    folder_.write("a.toml", sceneTitled(title));
    const Outcome outcome = run("plot a.toml --methods leapfrog --out out");
    EXPECT_EQ(outcome.code, 0) << title << outcome.err;
    expectXml("out/plot.svg");
  }
  EXPECT_TRUE(holds(contentsOf(folder_ / "out/plot.svg"), ">'7#1\\7 \\: the way of")) << "the last one";
}

TEST_F(NastyTexts, EveryCommandTakesThemAll) {
  std::string title;
  for (const char* part : kTitles) title += std::string(part) + " ";
  folder_.write("a.toml", sceneTitled(title));
  for (const char* command :
       {"stability a.toml --methods leapfrog --out out", "chart a.toml --quick --methods leapfrog --out out",
        "run a.toml --out out/samples.csv", "run a.toml --json", "render a.toml --size 64x48 --out out/a.png",
        "diet a.toml --out out", "diet a.toml --out out --json",
        "advise a.toml --error 1mm --write out/advised.toml"}) {
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.code, 0) << command << outcome.err;
  }
  expectXml("out/stability.svg");
  expectXml("out/chart.svg");
  for (const char* written : {"out/advised.toml", "out/lean.toml"}) {
    EXPECT_FALSE(hasActive(contentsOf(folder_ / written)));
    EXPECT_EQ(run(std::string("run ") + written).code, 0) << contentsOf(folder_ / written);
  }
}

TEST_F(NastyTexts, NamesOfFilesAreWrittenSoThatTheyReadBack) {
  for (const std::string name : kFileNames) {
    folder_.write(name + ".toml", sceneTitled("a"));
    fs::create_directories(folder_ / "out");
    const std::string scene = inQuotes("./" + name + ".toml");
    for (const std::string& command :
         {"run " + scene, "advise " + scene + " --integrator leapfrog --error 1mm --write out/advised.toml"}) {
      EXPECT_EQ(run(command).code, 0) << command;
    }
    EXPECT_EQ(run("run out/advised.toml").code, 0) << contentsOf(folder_ / "out/advised.toml");
  }
}

TEST_F(NastyTexts, AChartOfAFileWhoseNameIsNotUtf8CanBeComparedWith) {
  const std::string name = "e\xFF\n.toml";
  folder_.write(name, sceneTitled("a"));
  const std::string chart = "chart " + inQuotes(name) + " --quick --methods leapfrog --out out";
  ASSERT_EQ(run(chart).code, 0);
  const Outcome outcome = run(chart + " --compare out/rows.csv");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
}

TEST_F(NastyTexts, FoldersAreDrawnInWhateverTheyAreCalled) {
  folder_.write("a.toml", sceneTitled("a"));
  for (const std::string name : kFileNames) {
    const Outcome outcome = run("plot a.toml --methods leapfrog --out " + inQuotes("./" + name));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(fs::exists(folder_ / name / "plot.png")) << name;
  }
}

TEST_F(NastyTexts, WhatIsToBePastedIntoAShellIsInQuotes) {
  folder_.write("a.toml", sceneTitled("a"));
  const Outcome outcome = tyg("plot a.toml --methods leapfrog --out 'x $(touch owned)'",
                              "cd " + inQuotes(folder_.path().string()) + " && PATH=/nowhere");
  EXPECT_TRUE(holds(outcome.out, "`cd 'x $(touch owned)' && gnuplot plot.gp`")) << outcome.out;
}

TEST_F(NastyTexts, MessagesShowWhatTheyCannotUse) {
  for (const std::string& command :
       {"run " + inQuotes("no\x1B[31m.toml"), "run " + inQuotes("no\xFF.toml"), inQuotes("\x1B]0;x\x07"),
        "run curtain --dt " + inQuotes("\x1B[1m"), "render curtain --out " + inQuotes("no\x1B/a.jpg"),
        "run --replay " + inQuotes("\x9B")}) {
    EXPECT_EQ(run(command).code, 2) << command;
  }
}

}  // namespace
}  // namespace tyg

// Which command is meant, help, and exit codes.
#include "app/program.h"

#include <algorithm>
#include "tyg/methods.h"
#include "tyg/scene.h"

namespace tyg {
namespace {

const std::vector<std::string> kSceneOptions{"--integrator", "--dt",      "--tolerance", "--duration",
                                             "--precision",  "--threads", "--sheet"};

TEST(CommandLine, HelpNamesEveryCommandAndTheExitCodes) {
  const Outcome help = tyg("--help");
  EXPECT_EQ(help.code, 0);
  for (const char* word : {"view", "run", "render", "plot", "list", "Examples", "Exit codes", "--version"}) {
    EXPECT_TRUE(holds(help.out, word)) << word;
  }
}

TEST(CommandLine, HelpOfEveryCommandHasExamples) {
  for (const char* command : {"view", "run", "render", "plot", "list", "chart", "stability", "diet", "advise"}) {
    const Outcome help = tyg(std::string(command) + " --help");
    EXPECT_EQ(help.code, 0) << command;
    EXPECT_TRUE(holds(help.out, std::string("\n  tyg ") + command)) << command;
  }
}

TEST(CommandLine, HelpOfRunExplainsEveryOption) {
  const Outcome help = tyg("run --help");
  std::vector<std::string> options = kSceneOptions;
  options.insert(options.end(), {"--samples", "--out", "--ledger", "--keep-going", "--replay", "--json", "--verbose"});
  for (const std::string& option : options) EXPECT_TRUE(holds(help.out, "  " + option)) << option;
}

TEST(CommandLine, HelpOfPlotExplainsEveryOption) {
  const Outcome help = tyg("plot --help");
  std::vector<std::string> options = kSceneOptions;
  options.insert(options.end(), {"--particles", "--out"});
  for (const std::string& option : options) EXPECT_TRUE(holds(help.out, "  " + option)) << option;
}

TEST(CommandLine, VersionIsOneLine) {
  const Outcome version = tyg("--version");
  EXPECT_EQ(version.code, 0);
  EXPECT_EQ(version.out.rfind("tyg ", 0), 0U);
  EXPECT_EQ(std::count(version.out.begin(), version.out.end(), '\n'), 1);
}

TEST(CommandLine, AFirstWordThatIsNeitherCommandNorSceneIsRefusedWithBothLists) {
  const Outcome outcome = tyg("curtian");
  EXPECT_EQ(outcome.code, 2);
  for (const char* word : {"'curtian'", "view", "plot", "curtain", ".toml"})
    EXPECT_TRUE(holds(outcome.err, word)) << word;
}

TEST(CommandLine, AnOptionWithoutACommandBelongsToView) {
  const Outcome outcome = tyg("--window hat");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(holds(outcome.err, "tyg view")) << outcome.err;
  EXPECT_TRUE(holds(outcome.err, "found 'hat', allowed is glfw, glut")) << outcome.err;
}

TEST(CommandLine, AnUnknownOptionIsRefusedWithTheAllowedOnes) {
  const Outcome outcome = tyg("run curtain --integrater rk4");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(holds(outcome.err, "--integrater"));
  EXPECT_TRUE(holds(outcome.err, "--integrator"));
  EXPECT_TRUE(outcome.out.empty());
}

TEST(CommandLine, AnUnknownOptionIsNamedEvenWhereTheSceneIsMissing) {
  for (const char* command : {"run", "chart", "stability"}) {
    const Outcome outcome = tyg(std::string(command) + " --foo");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_TRUE(holds(outcome.err, "--foo")) << outcome.err;
    EXPECT_TRUE(holds(outcome.err, "--integrator")) << outcome.err;
    EXPECT_FALSE(holds(outcome.err, "required")) << outcome.err;
  }
}

TEST(CommandLine, WithoutASceneACommandTakesTheCurtain) {
  const Outcome outcome = tyg("run --duration 10ms --json");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(jsonValue(outcome.out, "scene"), "\"curtain\"");
}

TEST(CommandLine, AmountsHaveUnitsAndANumberAloneIsInSecondsOrMetres) {
  const std::string run = "run curtain --integrator dopri54 --json ";
  const Outcome plain = tyg(run + "--duration 0.02 --tolerance 1.9e-3");
  const Outcome units = tyg(run + "--duration 20ms --tolerance 1.9mm");
  const Outcome share = tyg(run + "--duration 20ms --tolerance 0.1%");  // of 1.9 m
  EXPECT_EQ(plain.code, 0) << plain.err;
  EXPECT_EQ(jsonValue(units.out, "hash"), jsonValue(plain.out, "hash"));
  EXPECT_EQ(jsonValue(share.out, "hash"), jsonValue(plain.out, "hash"));
}

TEST(CommandLine, WordsThatAreNearlyRightAreAnsweredWithTheRightOne) {
  for (const auto& [typed, meant] : {std::pair{"run curtian", "'curtain'"},
                                     {"curtian", "'curtain'"},
                                     {"stabilty", "'stability'"},
                                     {"run --integrator leap-frog", "'leapfrog'"},
                                     {"run --integrater rk4", "'--integrator'"},
                                     {"run --precision dubble", "'double'"},
                                     {"plot --particles midle", "'middle'"}}) {
    const Outcome outcome = tyg(typed);
    EXPECT_EQ(outcome.code, 2) << typed;
    EXPECT_TRUE(holds(outcome.err, std::string("did you mean ") + meant)) << outcome.err;
  }
}

TEST(CommandLine, MethodsIsAnotherNameOfIntegrator) {
  const Outcome one = tyg("run spring --integrator leapfrog --json"),
                other = tyg("run spring --methods leapfrog --json");
  EXPECT_EQ(other.code, 0) << other.err;
  EXPECT_EQ(jsonValue(one.out, "hash"), jsonValue(other.out, "hash"));
  EXPECT_EQ(tyg("run spring --integrator leapfrog,rk4").code, 2);
}

struct Wrong {
  const char* arguments;
  std::vector<std::string> words;  ///< that the message must hold
};

TEST(CommandLine, WrongValuesAreRefusedWithWhatWasFoundAndWhatIsAllowed) {
  const std::vector<Wrong> table{
      {"--dt 0", {"--dt", "'0'", "above 0"}},
      {"--dt nan", {"--dt", "'nan'", "finite"}},
      {"--dt 1e999", {"--dt", "'1e999'"}},
      {"--dt 2mm", {"--dt", "'2mm'", "seconds"}},
      {"--dt 1e-300", {"--dt", "1e-300", "steps"}},
      {"--duration -1", {"--duration", "'-1'", "above 0"}},
      {"--tolerance inf", {"--tolerance", "'inf'", "metres"}},
      {"--threads 0", {"--threads", "'0'", "from 1"}},
      {"--threads two", {"--threads", "'two'"}},
      {"--sheet 20", {"--sheet", "'20'", "4096"}},
      {"--sheet 0x4", {"--sheet", "'0x4'"}},
      {"--sheet 4097x4", {"--sheet", "'4097x4'"}},
      {"--precision half", {"--precision", "'half'", "float", "double"}},
      {"--integrator euler", {"euler", "explicit-euler", "rk4"}},
      {"--samples 0", {"--samples", "'0'"}},
  };
  for (const Wrong& wrong : table) {
    const Outcome outcome = tyg(std::string("run curtain ") + wrong.arguments);
    EXPECT_EQ(outcome.code, 2) << wrong.arguments;
    for (const std::string& word : wrong.words) {
      EXPECT_TRUE(holds(outcome.err, word)) << wrong.arguments << ": " << outcome.err;
    }
  }
}

TEST(CommandLine, AWrongSceneFileIsRefusedWithFileAndKey) {
  const Folder folder;
  const std::string text =
      "title = \"odd\"\n[sheet]\ncolumns = 3\nrows = 3\nspacing = 0.1\nparticle_mass = 0.1\nweight = 3\n"
      "[run]\nduration = 1\nintegrator = \"rk4\"\ndt = 0.01\n";
  const std::string file = folder.write("odd.toml", text).string();
  const Outcome outcome = tyg("run " + file);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(holds(outcome.err, "odd.toml")) << outcome.err;
  EXPECT_TRUE(holds(outcome.err, "weight")) << outcome.err;
}

TEST(CommandLine, ListShowsEverySceneAndMethodWithinEightyColumns) {
  const Outcome list = tyg("list");
  EXPECT_EQ(list.code, 0);
  for (const char* word : {"curtain", "flag", "drop", "symplectic-euler", "report-rk4"}) {
    EXPECT_TRUE(holds(list.out, word)) << word;
  }
  std::istringstream lines(list.out);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
}

TEST(CommandLine, ListAsJsonHoldsTheSameNames) {
  const Outcome list = tyg("list --json");
  EXPECT_EQ(list.code, 0);
  const auto value = [&](const std::string& kind, std::size_t number, const std::string& key) {
    return jsonValue(list.out, kind + "/" + std::to_string(number) + key);
  };
  for (std::size_t k = 0; k < methods().size(); ++k) {
    EXPECT_EQ(value("methods", k, "/name"), '"' + std::string(methods()[k].name) + '"');
  }
  const std::size_t scenes = builtinScenes().size();
  EXPECT_EQ(value("scenes", 0, "/name"), "\"curtain\"");
  EXPECT_EQ(value("scenes", 0, "/fails"), "false");
  EXPECT_EQ(value("scenes", scenes - 1, "/fails"), "true") << "those that fail come last";
  EXPECT_EQ(value("scenes", scenes, ""), "missing");
}

}  // namespace
}  // namespace tyg

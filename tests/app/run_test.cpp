// `tyg run`: what it reports, what it writes, and how it fails.
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <regex>
#include <thread>

#include "app/program.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg {
namespace {

const std::vector<std::string> kKeys{"scene",
                                     "columns",
                                     "rows",
                                     "integrator",
                                     "precision",
                                     "threads",
                                     "device",
                                     "device_name",
                                     "same_bits",
                                     "stray_m",
                                     "dt_asked",
                                     "dt",
                                     "steps",
                                     "force_evaluations",
                                     "seconds",
                                     "simulated_seconds",
                                     "kinetic_J",
                                     "elastic_J",
                                     "gravitational_J",
                                     "work_J",
                                     "dissipated_J",
                                     "ledger_drift",
                                     "max_stretch",
                                     "broken_springs",
                                     "stable_dt",
                                     "hash",
                                     "status"};

std::string json(const std::string& arguments) { return tyg("run " + arguments + " --json").out; }

TEST(Run, JsonIsOneObjectWithTheAgreedKeysInOrder) {
  const Outcome outcome = tyg("run curtain --duration 0.1 --json");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(isFlatJson(outcome.out)) << outcome.out;
  EXPECT_EQ(jsonKeys(outcome.out), kKeys);
}

TEST(Run, CountsTheSpringsThatCutsHaveTaken) {
  EXPECT_EQ(jsonValue(json("curtain --duration 0.01"), "broken_springs"), "0");
  EXPECT_FALSE(holds(tyg("run curtain --duration 0.01").out, "broken"));
  const Folder folder;
  const std::string sheet =
      "title = 'Cut'\n[sheet]\ncolumns = 4\nrows = 2\nspacing = 0.1\nparticle_mass = 0.01\npins = ['top']\n"
      "[run]\nintegrator = 'rk4'\ndt = 0.001\nduration = 0.01\n[[cut]]\nfrom = [1.5, -1]\nto = [1.5, 2]\nat = 0\n"
      "[springs]\nstructural = { ks = 50 }\nshear = { ks = 50 }\n";
  // Two springs along the rows, and both diagonals of the cell between them.
  const std::string file = folder.write("cut.toml", sheet).string();
  EXPECT_EQ(jsonValue(json(file), "broken_springs"), "4") << tyg("run " + file).err;
  EXPECT_TRUE(holds(tyg("run " + file).out, "broken        4 springs, cut or torn"));
  // And two bend springs over it.
  const std::string bent = folder.write("bent.toml", sheet + "bend = { ks = 5 }\n").string();
  EXPECT_EQ(jsonValue(json(bent), "broken_springs"), "8");
}

TEST(Run, JsonComesAfterAFailureToo) {
  const Outcome outcome = tyg("run curtain --dt 0.01 --json");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(isFlatJson(outcome.out)) << outcome.out;
  EXPECT_EQ(jsonKeys(outcome.out), kKeys);
  EXPECT_NE(jsonValue(outcome.out, "status"), "\"ok\"");
}

TEST(Run, OfEverySceneThatFailsSaysWhatAndWhatToDo) {
  for (const BuiltinScene& scene : builtinScenes()) {
    if (!showsFailure(scene)) continue;
    const Outcome outcome = tyg("run " + std::string(scene.name));
    EXPECT_EQ(outcome.code, 1) << scene.name;
    for (const char* part : {"with steps of", "became unstable", "redicted", "Try --"}) {
      EXPECT_TRUE(holds(outcome.err, part)) << scene.name << ": " << part << " in " << outcome.err;
    }
  }
}

TEST(Run, WithoutTheLedgerDissipationAndDriftAreNull) {
  const std::string without = json("curtain --duration 0.1"), with = json("curtain --duration 0.1 --ledger");
  EXPECT_EQ(jsonValue(without, "dissipated_J"), "null");
  EXPECT_EQ(jsonValue(without, "ledger_drift"), "null");
  EXPECT_GT(std::stod(jsonValue(with, "dissipated_J")), 0);
  EXPECT_LT(std::abs(std::stod(jsonValue(with, "ledger_drift"))), 1e-3);
}

TEST(Run, NumbersThatAreNotFiniteAreNull) {
  const Outcome outcome = tyg("run curtain --dt 0.05 --duration 20 --keep-going --json");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(isFlatJson(outcome.out)) << outcome.out;
  EXPECT_EQ(jsonValue(outcome.out, "kinetic_J"), "null");
  EXPECT_NE(jsonValue(outcome.out, "status"), "\"ok\"");
}

TEST(Run, AnUnlimitedSceneHasNoStableStep) {
  EXPECT_EQ(jsonValue(json("drop --integrator xpbd"), "stable_dt"), "null");
}

TEST(Run, EveryOverrideReachesTheSimulation) {
  const std::string report =
      json("curtain --integrator leapfrog --dt 0.001 --duration 0.05 --precision float --threads 3 --sheet 12x12");
  EXPECT_EQ(jsonValue(report, "integrator"), "\"leapfrog\"");
  EXPECT_EQ(jsonValue(report, "dt_asked"), "0.001");
  EXPECT_EQ(jsonValue(report, "steps"), "50");
  EXPECT_EQ(jsonValue(report, "simulated_seconds"), "0.05");
  EXPECT_EQ(jsonValue(report, "precision"), "\"float\"");
  EXPECT_EQ(jsonValue(report, "threads"), "3");
  EXPECT_EQ(jsonValue(report, "columns"), "12");
  EXPECT_EQ(jsonValue(report, "rows"), "12");
}

TEST(Run, ATighterToleranceMakesAnAdaptiveMethodTakeMoreSteps) {
  const auto steps = [](const std::string& tolerance) {
    return std::stoi(jsonValue(json("curtain --integrator bs32 --duration 0.5 --tolerance " + tolerance), "steps"));
  };
  EXPECT_GT(steps("1e-8"), 2 * steps("1e-4"));
}

TEST(Run, TheSummaryNamesUnitsStatusAndHash) {
  const Outcome outcome = tyg("run curtain --duration 0.1");
  EXPECT_EQ(outcome.code, 0);
  for (const char* word : {"rk4", " s ", " J", "hash", "status        ok", "stable step"}) {
    EXPECT_TRUE(holds(outcome.out, word)) << word;
  }
  EXPECT_TRUE(outcome.err.empty()) << outcome.err;
}

TEST(Run, VerboseSaysWhatIsSimulatedOnStandardErrorOnly) {
  const Outcome outcome = tyg("run poke --verbose --json");
  for (const char* word : {"rk4", "order 4", "thread", "0.5 s to 0.6 s"}) EXPECT_TRUE(holds(outcome.err, word)) << word;
  EXPECT_TRUE(isFlatJson(outcome.out));
}

TEST(Run, AFailureNamesMethodStepTimeLimitAndAWayOut) {
  const Outcome outcome = tyg("run curtain --integrator symplectic-euler --dt 0.004");
  EXPECT_EQ(outcome.code, 1);
  for (const char* word : {"symplectic-euler", "0.004 s", "t = ", "0.002788 s", "--dt 0.0025", "stripes in plane"}) {
    EXPECT_TRUE(holds(outcome.err, word)) << word << " is not in: " << outcome.err;
  }
}

TEST(Run, EnergiesOfAClothThatHasFlownApartAreNotPrintedAndThoseOfOneThatTremblesAre) {
  for (const char* past : {"run wet --integrator rkc2 --dt 0.12", "run wet --dt 0.01 --duration 1 --keep-going"}) {
    const Outcome apart = tyg(past);
    EXPECT_TRUE(holds(apart.out, "without meaning")) << apart.out;
    for (const char* word : {"kinetic", " J", "stretch"}) EXPECT_FALSE(holds(apart.out, word)) << apart.out;
  }
  const Outcome trembles = tyg("run fail-jitter");
  EXPECT_EQ(trembles.code, 1);
  EXPECT_TRUE(holds(trembles.out, "kinetic")) << trembles.out;
}

TEST(Run, ThatRoundingSpoilsIsAdvisedALongerStepOrDouble) {
  const Outcome outcome = tyg("run spring --precision float --dt 1e-6 --duration 0.05");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(holds(outcome.err, "rounding of float. Try --precision double, or --dt 0.0")) << outcome.err;
  EXPECT_TRUE(holds(outcome.err, "each was tried and holds.")) << outcome.err;
}

TEST(Run, IsHaltedWhereTheStepsOfAToleranceWouldNeverEnd) {
  for (const char* more : {"", " --keep-going --json"}) {
    const Outcome outcome = tyg(std::string("run curtain --integrator bs32 --tolerance 1e-300") + more);
    if (*more == 0) {
      EXPECT_EQ(outcome.code, 1);
      EXPECT_TRUE(holds(outcome.err, "bs32 was halted at t = ")) << outcome.err;
      std::smatch advice;
      ASSERT_TRUE(std::regex_search(outcome.err, advice, std::regex("Try (--tolerance [0-9.e-]+[0-9])")))
          << outcome.err;
      EXPECT_TRUE(holds(outcome.err, "which was tried and holds.")) << outcome.err;
      EXPECT_EQ(tyg("run curtain --integrator bs32 " + advice[1].str()).code, 0) << advice[1];
    } else {
      EXPECT_EQ(jsonValue(outcome.out, "status"), "\"not-finite\"");
    }
  }
}

/// A gigabyte of addresses is none too many for the stacks of a thousand threads.
TEST(Run, WithMoreThreadsThanTheSystemGivesUsesThoseThatThereAre) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer needs terabytes of addresses";
#endif
  const std::string run = "run curtain --duration 0.02 --json --threads ";
  const Outcome few = tyg(run + "1000", "ulimit -v 1000000;"), one = tyg(run + "1");
  EXPECT_EQ(few.code, 0) << few.err;
  EXPECT_LT(std::stoi(jsonValue(few.out, "threads")), 1000);
  EXPECT_EQ(jsonValue(few.out, "hash"), jsonValue(one.out, "hash"));
}

TEST(Run, TheAdvisedStepHolds) {
  const Outcome failed = tyg("run curtain --integrator leapfrog --dt 0.004");
  std::smatch advice;
  ASSERT_TRUE(std::regex_search(failed.err, advice, std::regex("Try (--dt [0-9.e-]+[0-9])"))) << failed.err;
  EXPECT_EQ(tyg("run curtain --integrator leapfrog " + advice[1].str()).code, 0);
}

/// Every way out that the sentence names ends well, whether the failure has to do with a limit or not.
TEST(Run, EveryAdvisedWayOutHolds) {
  for (const char* run : {"run chain --integrator xpbd --dt 0.01", "run curtain --integrator xpbd --dt 0.03",
                          "run curtain --integrator leapfrog --dt 0.004", "run fail-stretched", "run fail-wet",
                          "run fail-explicit-euler", "run spring --precision float --dt 1e-6 --duration 0.05"}) {
    const Outcome failed = tyg(run);
    ASSERT_EQ(failed.code, 1) << run;
    std::string words = failed.err.substr(failed.err.find("Try ") + 4);
    const std::regex way("--(dt|integrator|precision) [a-z0-9.-]+[a-z0-9]");
    int ways = 0;
    for (std::smatch found; std::regex_search(words, found, way); words = found.suffix()) {
      const std::regex before("--" + found[1].str() + " [^ ]+");  // an option is given once
      const std::string again = std::regex_replace(std::string(run), before, "") + " " + found.str();
      EXPECT_EQ(tyg(again).code, 0) << again;
      ++ways;
    }
    EXPECT_GT(ways, 0) << failed.err;
    EXPECT_TRUE(holds(failed.err, "tried and holds.")) << failed.err;
  }
}

const char* const kTwoParticles =
    "title = \"Two\"\n[sheet]\ncolumns = 2\nrows = 1\nspacing = 1\nparticle_mass = 0.1\npins = [\"top-left\"]\n";

TEST(Run, TellsWhatTheMethodLostFromWhatDampersTook) {
  const Folder folder;
  const std::string run = "\n[run]\nduration = 2\nintegrator = \"backward-euler\"\ndt = 0.0166\n";
  const std::string undamped = std::string(kTwoParticles) + "[springs]\nstructural = { ks = 10000 }" + run;
  const std::string scene = folder.write("pendulum.toml", undamped).string();
  for (const char* ledger : {"", " --ledger"}) {
    const std::string report = tyg("run " + scene + ledger).out;
    EXPECT_TRUE(holds(report, "the method itself lost 0.8")) << report;
    const std::string better = tyg("run " + scene + " --integrator rk4 --dt 0.001" + ledger).out;
    EXPECT_FALSE(holds(better, "the method itself lost 0.8")) << better;
  }
}

TEST(Run, TellsWhereTheWorkOfTheWindIsEstimated) {
  EXPECT_TRUE(holds(tyg("run sail --duration 0.1").out, "work of wind about "));
  const std::string exact = tyg("run sail --duration 0.1 --ledger").out;
  EXPECT_TRUE(holds(exact, "work of wind "));
  EXPECT_FALSE(holds(exact, "about ")) << exact;
}

TEST(Run, ADriftWithoutAnEnergyIsNoNumber) {
  const Folder folder;
  const std::string text = std::string(kTwoParticles) +
                           "[world]\ngravity = [0, 0, 0]\n[run]\nduration = 1\nintegrator = \"rk4\"\ndt = 0.01\n";
  const std::string scene = folder.write("still.toml", text).string();
  EXPECT_TRUE(holds(tyg("run " + scene + " --ledger").out, "no energy is there to compare a drift with"));
  EXPECT_EQ(jsonValue(json(scene + " --ledger"), "ledger_drift"), "null");
}

TEST(Run, OfNumbersThatCannotBeComputedWithIsRefused) {
  const Folder folder;
  std::string text = std::string(kTwoParticles) + "[run]\nduration = 1\nintegrator = \"rk4\"\ndt = 0.01\n";
  text.replace(text.find("spacing = 1"), 11, "spacing = 1e300");
  const Outcome outcome = tyg("run " + folder.write("vast.toml", text).string() + " --precision float");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(holds(outcome.err, "sheet.spacing: found 1e+300")) << outcome.err;
}

TEST(Run, RemarksThatStepsMoveTheClothByRoundingAlone) {
  const std::string run = "run curtain --sheet 4x4 --integrator symplectic-euler --duration 0.01 --precision ";
  EXPECT_TRUE(holds(tyg(run + "float --dt 1e-6").out, "rounding of float"));
  EXPECT_FALSE(holds(tyg(run + "double --dt 1e-6").out, "rounding of"));
  EXPECT_FALSE(holds(tyg(run + "float --dt 1e-3").out, "rounding of"));
}

TEST(Run, KeepsBothSidesOfASheetOrRefusesWithTheNearestGrids) {
  const Outcome refused = tyg("run hammock --sheet 24x64");
  EXPECT_EQ(refused.code, 2);
  for (const char* grid : {"24x64", "24x16", "98x64"}) EXPECT_TRUE(holds(refused.err, grid)) << refused.err;
  for (const char* fits : {"12x8", "47x31", "24x16"}) {
    EXPECT_EQ(tyg(std::string("run hammock --duration 0.01 --sheet ") + fits).code, 0) << fits;
  }
  EXPECT_EQ(tyg("run chain --duration 0.01 --sheet 1x39").code, 0);
}

TEST(Run, TheAdvisedToleranceHolds) {
  for (const char* method : {"bs32", "dopri54"}) {
    const std::string run = std::string("run curtain --integrator ") + method;
    const Outcome failed = tyg(run + " --tolerance 0.05");
    EXPECT_EQ(failed.code, 1);
    for (const char* word : {method, "at rest", "stripes in plane"}) EXPECT_TRUE(holds(failed.err, word)) << failed.err;
    std::smatch advice;
    ASSERT_TRUE(std::regex_search(failed.err, advice, std::regex("Try (--tolerance [0-9.e-]+[0-9])"))) << failed.err;
    EXPECT_EQ(tyg(run + " " + advice[1].str()).code, 0) << advice[1];
  }
}

TEST(Run, SamplesAreWrittenAtEquallySpacedTimes) {
  const Folder folder;
  const std::filesystem::path file = folder / "rows.csv";
  EXPECT_EQ(tyg("run spring --samples 4 --out " + file.string()).code, 0);
  std::istringstream rows(contentsOf(file));
  std::string row;
  std::getline(rows, row);
  EXPECT_EQ(row, "t,particle,x,y,z,vx,vy,vz");
  for (const double time : {2.5, 5.0, 7.5, 10.0}) {
    for (const char* particle : {"0", "1"}) {
      ASSERT_TRUE(std::getline(rows, row));
      EXPECT_DOUBLE_EQ(std::stod(row), time);
      EXPECT_EQ(row.substr(row.find(',') + 1, 1), particle);
    }
  }
  EXPECT_FALSE(std::getline(rows, row));
}

TEST(Run, SaysWhereSamplesHaveNoFileToGoTo) {
  const Outcome outcome = tyg("run spring --duration 0.1 --samples 4 --json");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "tyg run: without --out, --samples is not used\n");
  EXPECT_EQ(tyg("run spring --duration 0.1 --json").err, "");
}

TEST(Run, SampledNumbersReadBackToTheSameBits) {
  const Folder folder;
  const std::string file = (folder / "rows.csv").string();
  ASSERT_EQ(tyg("run spring --samples 1 --out " + file).code, 0);
  const Scene scene = loadScene("spring");
  Simulation simulation(scene, findMethod(scene.integrator));
  simulation.advanceTo(scene.duration);
  const std::string text = contentsOf(file), last = text.substr(text.rfind('\n', text.size() - 2) + 1);
  std::istringstream row(last);
  std::string field;
  for (int skipped = 0; skipped < 4; ++skipped) std::getline(row, field, ',');
  EXPECT_EQ(std::strtod(field.c_str(), nullptr), simulation.position(1).y) << last;
}

TEST(Run, ByDefaultTwentyTimesAreSampled) {
  const Folder folder;
  EXPECT_EQ(tyg("run chain --out " + (folder / "rows.csv").string()).code, 0);
  EXPECT_EQ(linesOf(folder / "rows.csv"), 1U + 20U * 20U);
}

TEST(Run, AnOutputThatCannotBeWrittenIsRefusedBeforeAnythingIsComputed) {
  const Outcome outcome = tyg("run curtain --dt 1e-7 --duration 1000 --out /nowhere/at/all.csv");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(holds(outcome.err, "/nowhere/at/all.csv")) << outcome.err;
}

TEST(Run, AFailedRunLeavesTheOldFileAlone) {
  const Folder folder;
  const std::filesystem::path file = folder.write("rows.csv", "old");
  EXPECT_EQ(tyg("run curtain --dt 0.01 --out " + file.string()).code, 1);
  EXPECT_EQ(contentsOf(file), "old");
  EXPECT_EQ(folder.fileCount(), 1U);
}

TEST(Run, AnInterruptLeavesNoFileAndSaysSo) {
  const Folder output, messages;
  const std::string out = (output / "rows.csv").string(), err = (messages / "err").string();
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    if (std::freopen(err.c_str(), "w", stderr) == nullptr) _exit(3);
    execl(TYG_PROGRAM, "tyg", "run", "curtain", "--duration", "1e6", "--verbose", "--out", out.c_str(), nullptr);
    _exit(3);
  }
  int status = 0;
  while (!holds(contentsOf(err), "span") && waitpid(child, &status, WNOHANG) == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  kill(child, SIGINT);
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_TRUE(holds(contentsOf(err), "interrupted")) << contentsOf(err);
  EXPECT_EQ(output.fileCount(), 0U);
}

}  // namespace
}  // namespace tyg

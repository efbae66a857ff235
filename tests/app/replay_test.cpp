// `tyg run --replay`: a log done again, and what it refuses.
#include <iomanip>

#include "app/program.h"
#include "app/reports/run_report.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg {
namespace {

/// A log as the window writes it, of thirty ticks with a push among them.
EventLog shortLog(const std::string& hash) {
  EventLog log;
  log.scene = "curtain";
  log.columns = log.rows = 20;
  log.integrator = "leapfrog";
  log.dt = 0.001;
  log.precision = Precision::Float;
  log.ticks = 30;
  log.hash = hash;
  log.events = {{10, PushEvent{210, {0, 0, 3}, 5}}};
  return log;
}

std::string replayed(const Folder& folder, const std::string& hash, const std::string& more, Outcome& outcome) {
  const std::string file = folder.write("clicks.csv", formatEventLog(shortLog(hash))).string();
  outcome = tyg("run curtain --json --replay " + file + " " + more);
  return outcome.out.empty() ? "missing" : jsonValue(outcome.out, "hash");
}

TEST(Replay, UsesTheLogsMethodStepAndPrecisionAndEndsInTheSameBits) {
  Scene scene = loadScene("curtain");
  scene.precision = Precision::Float;
  scene.dt = 0.001;
  Simulation simulation(scene, findMethod("leapfrog"));
  for (int tick = 0; tick < 30; ++tick) {
    if (tick == 10) simulation.push(210, {0, 0, 3}, 5);
    simulation.tick();
  }
  std::ostringstream hash;
  hash << std::hex << std::setw(16) << std::setfill('0') << simulation.hash();

  const Folder folder;
  Outcome outcome;
  EXPECT_EQ(replayed(folder, hash.str(), "", outcome), '"' + hash.str() + '"') << outcome.err;
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(jsonValue(outcome.out, "integrator"), "\"leapfrog\"");
  EXPECT_EQ(jsonValue(outcome.out, "precision"), "\"float\"");
}

TEST(Replay, WithoutASceneUsesTheOneInItsLog) {
  Scene moon = loadScene("curtain");
  moon.gravity = {0, -1.62, 0};
  Simulation simulation(moon, findMethod("leapfrog"));
  simulation.push(210, {0, 0, 3}, 5);
  simulation.tick(30);
  EventLog log = simulation.log();
  log.hash = hashText(simulation);
  const Folder folder;
  const std::string file = folder.write("moon.csv", formatEventLog(log)).string();
  const Outcome own = tyg("run --json --replay " + file);
  EXPECT_EQ(own.code, 0) << own.err;
  EXPECT_EQ(jsonValue(own.out, "hash"), '"' + log.hash + '"');
  EXPECT_TRUE(own.err.empty()) << own.err;
  const Outcome other = tyg("run curtain --replay " + file);
  EXPECT_EQ(other.code, 1);
  EXPECT_TRUE(holds(other.err, "without SCENE")) << other.err;
}

TEST(Replay, OfAMethodThatChoosesItsStepsEndsInTheSameBits) {
  Scene scene = loadScene("drop");
  scene.structural = scene.shear = scene.bend = {};  // then the duration sets the first step
  scene.integrator = "dopri54";
  scene.pushes = {{Place{"top-left"}, {1, 2, 3}, 0.003, 0.1}};
  Simulation simulation(scene, findMethod(scene.integrator));
  simulation.tick(10);
  EventLog log = simulation.log();
  log.hash = hashText(simulation);
  const Folder folder;
  const Outcome again = tyg("run --json --replay " + folder.write("drop.csv", formatEventLog(log)).string());
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(jsonValue(again.out, "hash"), '"' + log.hash + '"');
}

TEST(Replay, ThatEndsInOtherBitsFails) {
  const Folder folder;
  Outcome outcome;
  replayed(folder, "0123456789abcdef", "", outcome);
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(holds(outcome.err, "0123456789abcdef")) << outcome.err;
}

TEST(Replay, OnAnotherSheetOrPrecisionIsRefused) {
  const Folder folder;
  Outcome outcome;
  replayed(folder, "", "--sheet 10x10", outcome);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(holds(outcome.err, "20x20")) << outcome.err;
  replayed(folder, "", "--precision double", outcome);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(holds(outcome.err, "float")) << outcome.err;
}

TEST(Replay, OfAMissingFileIsRefused) {
  const Outcome outcome = tyg("run curtain --replay /nowhere.csv");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(holds(outcome.err, "/nowhere.csv"));
}

TEST(Replay, TakesTheLogsToleranceAndRefusesAnother) {
  Scene scene = loadScene("drop");
  scene.integrator = "bs32";
  scene.tolerance = 1e-3;
  Simulation simulation(scene, findMethod(scene.integrator));
  simulation.tick(10);
  EventLog log = simulation.log();
  log.hash = hashText(simulation);
  const Folder folder;
  const std::string file = folder.write("drop.csv", formatEventLog(log)).string();
  EXPECT_EQ(tyg("run --tolerance 1e-3 --replay " + file).code, 0);
  EXPECT_EQ(tyg("run drop --replay " + file).code, 0);
  const Outcome other = tyg("run --tolerance 1e-4 --replay " + file);
  EXPECT_EQ(other.code, 2);
  EXPECT_TRUE(holds(other.err, "--tolerance: the log given to --replay was made with 0.001 m; allowed is that"))
      << other.err;
}

}  // namespace
}  // namespace tyg

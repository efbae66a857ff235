// Logs that were written as version 1, by the window and by runs of many methods, still end in the bits that they
// recorded.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg::test {
namespace {

const std::filesystem::path kFolder = std::filesystem::path(TYG_SOURCE_DIR) / "tests/integrators/version_1_logs";

EventLog logIn(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return parseEventLog(text.str(), path.filename().string());
}

std::string hashAfter(const EventLog& log) {
  const Scene scene = parseScene(log.sceneText, log.scene, methodNames());
  Simulation simulation(scene, findMethod(log.integrator), {.threads = 1});
  simulation.replay(log, methods());
  simulation.tick(log.ticks);
  return hashText(simulation);
}

TEST(OldLogs, EndInTheBitsThatTheyRecorded) {
  int floats = 0, doubles = 0;
  for (const auto& file : std::filesystem::directory_iterator(kFolder)) {
    const EventLog log = logIn(file.path());
    EXPECT_EQ(log.hash.size(), 16U) << file.path();
    EXPECT_EQ(hashAfter(log), log.hash) << file.path();
    ++(log.precision == Precision::Float ? floats : doubles);
  }
  EXPECT_EQ(floats, 4);
  EXPECT_EQ(doubles, 6);
}

TEST(OldLogs, WrittenAsVersion2EndInTheSameBits) {
  const EventLog log = logIn(kFolder / "imex-double.csv");
  const EventLog again = parseEventLog(formatEventLog(log), "log");
  EXPECT_EQ(again, log);
  EXPECT_EQ(hashAfter(again), log.hash);
}

}  // namespace
}  // namespace tyg::test

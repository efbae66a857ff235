// What is written of a run is the same bytes on every system: a log with every kind of event, the text of its scene
// with every table of scene files in it, and the hash at the end.
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <variant>

#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg::test {
namespace {

constexpr const char* kLog = TYG_SOURCE_DIR "/tests/integrators/every_event.csv";

std::string storedText() {
  std::ostringstream text;
  text << std::ifstream(kLog, std::ios::binary).rdbuf();
  return text.str();
}

TEST(SameFiles, ARunWithEveryKindOfEventIsWrittenAsTheStoredBytes) {
  const EventLog stored = parseEventLog(storedText(), kLog);
  const Scene scene = parseScene(stored.sceneText, stored.scene, methodNames());
  Simulation simulation(scene, findMethod(stored.integrator), {.threads = 1});
  simulation.replay(stored, methods());
  simulation.tick(stored.ticks);
  EventLog log = simulation.log();
  log.ticks = simulation.ticks();
  log.hash = hashText(simulation);
  EXPECT_EQ(formatEventLog(log), storedText()) << "if the change is meant, " << kLog << " is to become the first text";
}

TEST(SameFiles, TheStoredRunHasEveryKindOfEventAndEveryTableOfAScene) {
  const EventLog stored = parseEventLog(storedText(), kLog);
  std::set<std::size_t> kinds;
  for (const Event& event : stored.events) kinds.insert(event.action.index());
  EXPECT_EQ(kinds.size(), std::variant_size_v<EventAction>);
  for (const char* table :
       {"[sheet]", "[springs]", "[world]", "[air]", "[[wind]]", "[contact]", "[[body]]", "[[displace]]", "[[push]]",
        "[[move]]", "[[cut]]", "[tear]", "[look]", "[[lamp]]", "[run]"}) {
    EXPECT_NE(stored.sceneText.find(table), std::string::npos) << table;
  }
}

}  // namespace
}  // namespace tyg::test

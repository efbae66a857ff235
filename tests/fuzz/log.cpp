// Fuzz target: event logs. What reads must write and read back, and must replay or be refused.
// Must not know: windows, commands.
#include <cstdlib>

#include "fuzz.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace {

void replay(const tyg::EventLog& log) {
  constexpr int kFewParticles = 64;
  if (log.sceneText.empty() || log.columns * log.rows > kFewParticles) return;
  const tyg::Scene scene = tyg::parseScene(log.sceneText, "fuzz", tyg::methodNames());
  const tyg::Method& method = tyg::findMethod(scene.integrator);
  if (method.adaptive || scene.columns * scene.rows > kFewParticles) return;
  tyg::Simulation simulation(scene, method);
  simulation.replay(log, tyg::methods());
  simulation.observe([] { return false; });  // events may choose an adaptive method
  simulation.tick(4);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const tyg::EventLog log = tyg::parseEventLog(textOf(data, size), "fuzz");
    const tyg::EventLog back = tyg::parseEventLog(tyg::formatEventLog(log), "fuzz");
    if (back.events != log.events) std::abort();
    replay(log);
  } catch (const tyg::InputError&) {
  }
  return 0;
}

// Fuzz target: scene files. What reads must write and read back, and its limits must be found or refused, whatever its
// numbers are. Must not know: windows, commands.
#include <cstdlib>

#include "core/scene/scene_range.h"
#include "core/scene/scene_writer.h"
#include "fuzz.h"
#include "study/limits/stability.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace {

void tryOut(const tyg::Scene& scene) {
  constexpr int kFewParticles = 64;
  if (scene.columns * scene.rows > kFewParticles) return;
  for (const tyg::Method& method : tyg::methods()) {
    try {
      (void)tyg::restLatticeLimit(scene, method);  // of numbers that a simulation refuses too
      (void)tyg::certifiedLimit(scene, method);
      if (method.adaptive) continue;  // a tick of it may be millions of steps
      tyg::Simulation simulation(scene, method);
      simulation.tick(2);
      if (!(simulation.time() >= 0)) std::abort();
    } catch (const tyg::InputError&) {
    }
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const tyg::Scene scene = tyg::parseScene(textOf(data, size), "fuzz", tyg::methodNames());
    const tyg::Scene back = tyg::parseScene(tyg::sceneToToml(scene), "fuzz", tyg::methodNames());
    if (!(back == scene)) std::abort();
    tryOut(scene);
  } catch (const tyg::InputError&) {
  }
  return 0;
}

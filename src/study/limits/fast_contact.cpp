// One product and one comparison.
#include "study/limits/fast_contact.h"

#include <fmt/core.h>

#include "core/forces/term.h"
#include "core/forces/terms/contact.h"
#include "util/amounts.h"

namespace tyg {

double layersPerStep(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  if (!hasTerm(scene, ContactTerm::kTerm)) return 0;
  return simulation.largestStep() * simulation.largestSpeed() / scene.contact.layer;
}

std::string fastContactNote(const Simulation& simulation) {
  constexpr double kMost = 1.0 / 3;
  const Scene& scene = simulation.scene();
  const double layers = layersPerStep(simulation), step = simulation.largestStep();
  const bool choosesSteps = simulation.method().adaptive && scene.tolerance > 0;
  if (choosesSteps || !(layers > kMost)) return "";
  return fmt::format(
      "At {:.3g} m/s a step of {:.3g} ms crosses {:.2g} {} the layer of contact, so that impacts are rough: take steps "
      "of {:.2g} ms, or a thicker layer.",
      simulation.largestSpeed(), 1e3 * step, layers, layers < 1 ? "of" : "times",
      1e3 * roundedDown(step * kMost / layers));
}

}  // namespace tyg

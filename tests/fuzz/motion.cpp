// Fuzz target: motions of another program, as CSV. What reads must write and read back to the same motion, and the
// steps that may have led to its times must lead there. Must not know: what is found out about a motion.
#include <algorithm>
#include <cstdlib>
#include <string>

#include "fuzz.h"
#include "study/check/motion_rows.h"
#include "tyg/input_error.h"
#include "util/csv.h"

namespace {

tyg::Scene threeParticles() {
  tyg::Scene scene;
  scene.name = "fuzz", scene.columns = 3, scene.rows = 1, scene.spacing = 0.5, scene.duration = 2;
  scene.structural.ks = 10;
  return scene;
}

std::string written(const tyg::GivenMotion& motion) {
  std::string text = tyg::csvLine("t", "particle", "x", "y", "z");
  for (std::size_t k = 0; k < motion.times.size(); ++k) {
    for (std::size_t i = 0; i < motion.positions[k].size(); ++i) {
      const tyg::Vec3& at = motion.positions[k][i];
      text += tyg::csvLine(motion.times[k], i, at.x, at.y, at.z);
    }
  }
  return text;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const tyg::Scene scene = threeParticles();
    const tyg::GivenMotion motion = tyg::readMotion(textOf(data, size), "fuzz", scene);
    for (const double dt : tyg::stepsOnto(motion, {1e-3})) {
      const std::vector<std::int64_t> counts = tyg::stepCounts(motion, dt);
      if (counts.size() != motion.times.size() || !std::ranges::is_sorted(counts)) std::abort();
    }
    const tyg::GivenMotion back = tyg::readMotion(written(motion), "fuzz", scene);
    if (back.times != motion.times || back.positions != motion.positions) std::abort();
  } catch (const tyg::InputError&) {
  }
  return 0;
}

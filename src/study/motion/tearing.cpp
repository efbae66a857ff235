// Three runs that would be the same but for what nobody can know.
#include "study/motion/tearing.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "study/motion/progress.h"
#include "study/motion/reference.h"
#include "tyg/methods.h"

namespace tyg {

std::optional<double> firstTornElsewhere(const SampledMotion& a, const SampledMotion& b) {
  const std::size_t count = std::min(a.missing.size(), b.missing.size());
  for (std::size_t k = 0; k < count; ++k) {
    if (!(a.missing[k] == b.missing[k])) return a.times[k];
  }
  return {};
}

std::string Tearing::words() const {
  if (!differs) return "";
  return fmt::format(
      "what tears is certain until t = {:.3g} s, and no later time is used: at {:.3g} s other springs are broken in a "
      "motion that differs by next to nothing",
      scene.duration, *differs);
}

Tearing untilTearsDiffer(const Scene& scene, int threads, const std::function<bool(double)>& observer) {
  Tearing tearing{scene, {}};
  if (!std::isfinite(strainThatTears(scene))) return tearing;
  refuseEndlessReference(scene);
  constexpr double kExact = 1e-10, kBeside = 1e-8;  // of the size
  const double size = makeSheet(scene).size();
  Scene exact = scene;
  exact.precision = Precision::Double;
  exact.tolerance = kExact * size;
  Scene oftener = exact;
  oftener.dt /= 2;
  const std::vector<double> times = sampleTimes(scene);
  Progress progress(observer);
  const auto motionOf = [&](const Scene& one, double done) {
    const auto goesOn = [&](double time) { return progress.reach(done + time / scene.duration / 3); };
    return sampledRun(one, findMethod("dopri54"), times, {.threads = threads, .observer = goesOn});
  };
  const SampledMotion motion = motionOf(exact, 0);
  for (const auto& [other, done] : {std::pair{twinOf(exact, kBeside * size), 1.0 / 3}, std::pair{oftener, 2.0 / 3}}) {
    const std::optional<double> differs = firstTornElsewhere(motion, motionOf(other, done));
    if (differs && (!tearing.differs || *differs < *tearing.differs)) tearing.differs = differs;
  }
  if (!tearing.differs || progress.stopped()) return {scene, {}};
  const auto end = std::ranges::lower_bound(times, *tearing.differs);
  if (end == times.begin()) {
    throw InputError(
        fmt::format("{}: found other springs broken at t = {:.3g} s in a motion that differs by next to "
                    "nothing; allowed are scenes whose tears are certain for longer",
                    scene.name, *tearing.differs));
  }
  tearing.scene.duration = *std::prev(end);
  return tearing;
}

}  // namespace tyg

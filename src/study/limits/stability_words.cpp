// What people read about a step limit: what the motion that fails first looks like, and what sets the limit.
#include <fmt/core.h>

#include <cmath>
#include <numbers>

#include "core/scene/bodies.h"
#include "study/limits/stability.h"

namespace tyg {
namespace {

enum class Phase { Same, Between, Opposite };  // of neighbours

Phase phaseOf(double q) {
  constexpr double kNear = 0.1 * std::numbers::pi;
  if (q < kNear) return Phase::Same;
  return q > std::numbers::pi - kNear ? Phase::Opposite : Phase::Between;
}

}  // namespace

std::string appearanceOf(const Scene& scene, const StepLimit& limit) {
  if (std::isnan(limit.predicted)) return "none";
  if (limit.byContact) return "a particle on " + bodiesInWords(scene);
  const Phase x = phaseOf(limit.qx), y = phaseOf(limit.qy);
  if (x == Phase::Same && y == Phase::Same) return "the whole sheet";
  if (scene.columns == 1 || scene.rows == 1) {
    return x == Phase::Opposite || y == Phase::Opposite ? "each against the next" : "ripples";
  }
  if (x == Phase::Opposite && y == Phase::Opposite) return "checkerboard";
  const bool stripes = x == Phase::Same || y == Phase::Same;
  if (!stripes) return x == Phase::Between && y == Phase::Between ? "diagonal ripples" : "rippled stripes";
  // Where bend springs fit both ways the lattice looks the same along rows and columns.
  const bool either = scene.columns > 2 && scene.rows > 2;
  return either ? "stripes" : x == Phase::Same ? "row stripes" : "column stripes";
}

std::string describe(const Scene& scene, const StepLimit& limit) {
  std::string appearance = appearanceOf(scene, limit);
  if (appearance == "none") return appearance;
  if (limit.byContact) {
    const bool slides = causeOf(limit) == "friction";
    return fmt::format("{}, set by {} with {}, not the springs", appearance, slides ? "friction in contact" : "contact",
                       bodiesInWords(scene));
  }
  return fmt::format("{} {}, q = ({:.2f}, {:.2f}), set by {}{}", appearance,
                     limit.outOfPlane ? "out of plane" : "in plane", limit.qx, limit.qy, causeOf(limit),
                     limit.damper != nullptr ? ", not the springs" : "");
}

std::string_view causeOf(const StepLimit& limit) {
  if (limit.byContact) return limit.mode.w2 > 0 ? "contact" : "friction";
  if (limit.damper != nullptr) return limit.damper->name;
  return limit.byDamping ? "damping" : "stiffness";
}

}  // namespace tyg

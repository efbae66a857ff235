// Units are told by the distance of neighbours at the first time, which no cloth changes much.
#include "study/check/motion_fit.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "study/motion/error.h"
#include "util/amounts.h"

namespace tyg {
namespace {

double distance(const Vec3& a, const Vec3& b) { return distanceBetween(std::span(&a, 1), std::span(&b, 1)).largest; }

/// The median distance of neighbours, as a multiple of their distance at rest.
double scaleOf(const std::vector<Vec3>& at, const Sheet& sheet) {
  std::vector<double> lengths;
  for (const SpringEnds& ends : springsOf(sheet, Family::Structural)) {
    lengths.push_back(distance(at[std::size_t(ends.first)], at[std::size_t(ends.second)]) / sheet.spacing);
  }
  if (lengths.empty()) return 1;
  const auto middle = lengths.begin() + std::ptrdiff_t(lengths.size() / 2);
  std::ranges::nth_element(lengths, middle);
  return *middle;
}

/// Where every particle is at t = 0, m.
std::vector<Vec3> startOf(const Scene& scene, const Sheet& sheet) {
  std::vector<Vec3> start;
  start.reserve(std::size_t(sheet.count()));
  for (int particle = 0; particle < sheet.count(); ++particle) start.push_back(sheet.startPosition(particle));
  for (const Displacement& one : scene.displacements) {
    Vec3& at = start[std::size_t(particleAt(sheet, one.particle))];
    at = {at.x + one.by.x, at.y + one.by.y, at.z + one.by.z};
  }
  return start;
}

/// Without the sign of -0.
std::string placeText(const Vec3& at) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g}) m", at.x + 0.0, at.y + 0.0, at.z + 0.0);
}

[[noreturn]] void refuse(const std::string& file, const std::string& found, const std::string& allowed) {
  throw InputError(fmt::format("{}: found {}; allowed: {}", file, found, allowed));
}

void refuseUnits(const GivenMotion& motion, const Sheet& sheet, const std::string& file) {
  struct Unit {
    double scale;
    const char* name;
  };
  const double scale = scaleOf(motion.positions.front(), sheet);
  for (const Unit& unit : {Unit{1000, "mm"}, Unit{100, "cm"}, Unit{1e-3, "km"}}) {
    if (!(std::abs(scale / unit.scale - 1) < 0.3)) continue;
    refuse(file,
           fmt::format("neighbours {:.4g} apart at t = {:g} s, {:g} times their distance at rest, as if positions were "
                       "in {}",
                       scale * sheet.spacing, motion.times.front(), unit.scale, unit.name),
           fmt::format("positions in m, in which they rest {:g} apart", sheet.spacing));
  }
}

void refuseStart(const GivenMotion& motion, const Scene& scene, const Sheet& sheet, const std::string& file) {
  constexpr double kWithin = 1e-3;  // of the spacing
  if (motion.times.front() != 0) return;
  const std::vector<Vec3> start = startOf(scene, sheet);
  for (std::size_t particle = 0; particle < start.size(); ++particle) {
    const Vec3& at = motion.positions.front()[particle];
    if (distance(at, start[particle]) <= kWithin * sheet.spacing + 2 * motion.rounding.front()) continue;
    refuse(file, fmt::format("particle {} at {} at t = 0", particle, placeText(at)),
           fmt::format("{}, where {} has it: particle (column c, row r) has the number r * {} + c, y is up",
                       placeText(start[particle]), scene.name, sheet.columns));
  }
}

void refuseTimes(const GivenMotion& motion, const Scene& scene, const std::string& file) {
  const double last = motion.times.back();
  if (last <= scene.duration * (1 + 1e-9) + motion.timeRounding) return;
  constexpr double kMilliseconds = 100;
  refuse(file,
         fmt::format("times up to {:g} s{}", last,
                     last > kMilliseconds * scene.duration ? ", as if they were in milliseconds or counted steps" : ""),
         fmt::format("times in s up to {}, which {} takes; --duration changes that", timeText(scene.duration),
                     scene.name));
}

}  // namespace

void refuseOtherMotion(const GivenMotion& motion, const Scene& scene, const std::string& file) {
  const Sheet sheet = makeSheet(scene);
  if (const std::size_t count = motion.positions.front().size(); count != std::size_t(sheet.count())) {
    refuse(file, fmt::format("{} particles", count),
           fmt::format("the {} x {} of {}", sheet.columns, sheet.rows, scene.name));
  }
  refuseTimes(motion, scene, file);
  refuseUnits(motion, sheet, file);
  refuseStart(motion, scene, sheet, file);
}

}  // namespace tyg

// Distances are measured at the samples alone, where nothing has to be guessed; what lies between them is for the eye.
#include "viewer/given_ghost.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tyg {

GivenGhost::GivenGhost(std::shared_ptr<const GivenMotion> motion, const Scene& scene)
    : motion_(std::move(motion)), sheet_(makeSheet(scene)) {
  const std::vector<double>& times = motion_->times;
  for (std::size_t k = 1; k < times.size(); ++k) interval_ = std::max(interval_, times[k] - times[k - 1]);
  positions_.resize(3 * static_cast<std::size_t>(sheet_.count()));
  distances_.resize(static_cast<std::size_t>(sheet_.count()));
  moveTo(0);
}

void GivenGhost::moveTo(double time) {
  const std::vector<double>& times = motion_->times;
  place_ = time < times.front() ? Place::Before : time > times.back() ? Place::After : Place::Within;
  const auto next = static_cast<std::size_t>(std::ranges::lower_bound(times, time) - times.begin());
  interpolate(std::min(next, times.size() - 1), std::clamp(time, times.front(), times.back()));
}

/// The velocity at a sample of the parabola through it and both of its neighbours (m/s), or along the straight line
/// where there is one neighbour only.
Vec3 GivenGhost::slopeAt(std::size_t sample, std::size_t particle) const {
  const std::vector<double>& times = motion_->times;
  const auto between = [&](std::size_t from, std::size_t to) {
    const Vec3 &a = motion_->positions[from][particle], &b = motion_->positions[to][particle];
    const double perSecond = 1 / (times[to] - times[from]);
    return Vec3{(b.x - a.x) * perSecond, (b.y - a.y) * perSecond, (b.z - a.z) * perSecond};
  };
  if (sample == 0) return between(0, 1);
  if (sample + 1 == times.size()) return between(sample - 1, sample);
  const Vec3 before = between(sample - 1, sample), after = between(sample, sample + 1);
  const double share = (times[sample] - times[sample - 1]) / (times[sample + 1] - times[sample - 1]);
  const auto mixed = [share](double a, double b) { return a + share * (b - a); };
  return {mixed(before.x, after.x), mixed(before.y, after.y), mixed(before.z, after.z)};
}

/// Hermite's cubic between the sample `next` and the one before it.
void GivenGhost::interpolate(std::size_t next, double time) {
  const GivenMotion& given = *motion_;
  const std::size_t last = next > 0 ? next - 1 : 0;
  const double h = given.times[next] - given.times[last], s = h > 0 ? (time - given.times[last]) / h : 1;
  const double toNext = s * s * (3 - 2 * s), atLast = h * s * (1 - s) * (1 - s), atNext = -h * s * s * (1 - s);
  for (std::size_t particle = 0; particle < given.positions[next].size(); ++particle) {
    const Vec3 &a = given.positions[last][particle], &b = given.positions[next][particle];
    const Vec3 va = h > 0 ? slopeAt(last, particle) : Vec3{}, vb = h > 0 ? slopeAt(next, particle) : Vec3{};
    float* const at = &positions_[3 * particle];
    at[0] = static_cast<float>(a.x + toNext * (b.x - a.x) + atLast * va.x + atNext * vb.x);
    at[1] = static_cast<float>(a.y + toNext * (b.y - a.y) + atLast * va.y + atNext * vb.y);
    at[2] = static_cast<float>(a.z + toNext * (b.z - a.z) + atLast * va.z + atNext * vb.z);
  }
}

std::int64_t GivenGhost::meet(const Simulation& live) {
  constexpr std::int64_t kFar = std::int64_t{1} << 40U;
  const std::vector<double>& times = motion_->times;
  const double time = live.time(), dt = live.dt();
  auto next = static_cast<std::size_t>(std::ranges::lower_bound(times, time - dt / 2) - times.begin());
  if (next < times.size() && times[next] <= time + dt / 2) {
    measure(live, next);
    while (next < times.size() && times[next] <= time + dt / 2) ++next;
  }
  if (next == times.size()) return kFar;
  const double ticks = std::ceil((times[next] - time) / dt - 0.5);
  return static_cast<std::int64_t>(std::clamp(ticks, 1.0, static_cast<double>(kFar)));
}

bool GivenGhost::differs() const {
  constexpr double kSame = 1e-9;  // of the size
  return gap_ && gap_->largest > kSame * sheet_.size();
}

/// The live cloth as it is, or by its velocity less than a tick earlier or later.
void GivenGhost::measure(const Simulation& live, std::size_t sample) {
  const double away = motion_->times[sample] - live.time();
  const double aside = std::abs(away) > 1e-9 * live.dt() ? away : 0;
  double square = 0, largest = 0;
  for (std::size_t particle = 0; particle < distances_.size(); ++particle) {
    const Vec3 x = live.position(static_cast<int>(particle)), v = live.velocity(static_cast<int>(particle));
    const Vec3& given = motion_->positions[sample][particle];
    const double apart =
        std::hypot(x.x + aside * v.x - given.x, x.y + aside * v.y - given.y, x.z + aside * v.z - given.z);
    square += apart * apart;
    largest = std::max(largest, apart);
    distances_[particle] = static_cast<float>(apart);
  }
  gap_ = {.time = motion_->times[sample],
          .rms = std::sqrt(square / static_cast<double>(distances_.size())),
          .largest = largest};
}

}  // namespace tyg

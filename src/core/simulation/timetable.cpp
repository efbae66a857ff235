// Edges lie at the begin and the end of everything that the scene gives a time.
#include "core/simulation/timetable.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace tyg {

Timetable::Timetable(const Scene& scene) {
  const auto add = [this](const auto& each) {
    edges_.push_back(each.at);
    if (std::isfinite(each.duration)) edges_.push_back(each.at + each.duration);
  };
  std::ranges::for_each(scene.winds, add);
  std::ranges::for_each(scene.moves, add);
  std::ranges::sort(edges_);
}

double Timetable::nextEdge(const Instant& now, double end) const {
  const auto next = std::ranges::upper_bound(edges_, now.time + now.sameTime);
  return next == edges_.end() || *next >= end - now.sameTime ? end : *next;
}

bool Timetable::isEdge(const Instant& now) const {
  const auto next = std::ranges::lower_bound(edges_, now.time - now.sameTime);
  return next != edges_.end() && *next <= now.time + now.sameTime;
}

std::vector<Wind> blowingAt(const Scene& scene, const Instant& now) {
  std::vector<Wind> blowing;
  std::ranges::copy_if(scene.winds, std::back_inserter(blowing),
                       [&](const Wind& wind) { return now.isWithin(wind.at, wind.duration); });
  return blowing;
}

}  // namespace tyg

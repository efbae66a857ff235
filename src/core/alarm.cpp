// See alarm.h.
#include "core/alarm.h"

#include <algorithm>
#include <cmath>

namespace tyg {

Status Alarm::look(double kinetic, double elastic, double gravitational, double work) {
  const double energy = kinetic + elastic + gravitational - work;
  if (!std::isfinite(energy)) return Status::NotFinite;
  largest_ = std::max({largest_, std::abs(gravitational), std::abs(work)});
  lowest_ = looked_ ? std::min(lowest_, energy) : energy;
  looked_ = true;
  return energy > lowest_ + kThreshold * scale() ? Status::Unstable : Status::Ok;
}

}  // namespace tyg

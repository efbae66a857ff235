// A ring of samples, taken whole at the start: adding one never allocates.
#include "viewer/running_series.h"

#include <algorithm>
#include <limits>

namespace tyg {

RunningSeries::RunningSeries(std::size_t channels, double window)
    : channels_(channels), window_(window), times_(kMost), values_(kMost * channels) {}

void RunningSeries::add(double time, std::span<const float> values) {
  const double least = window_ / double(kMost - 1);
  if (count_ > 0 && time - this->time(count_ - 1) < least) return;
  while (count_ == kMost || (count_ > 0 && this->time(0) < time - window_)) {
    first_ = (first_ + 1) % kMost;
    --count_;
  }
  const std::size_t at = slot(count_);
  times_[at] = time;
  std::copy_n(values.begin(), channels_, values_.begin() + static_cast<std::ptrdiff_t>(at * channels_));
  ++count_;
}

void RunningSeries::cut(double time) {
  while (count_ > 0 && this->time(count_ - 1) > time) --count_;
}

void RunningSeries::forget(std::size_t channel) {
  for (std::size_t k = 0; k < count_; ++k) {
    values_[slot(k) * channels_ + channel] = std::numeric_limits<float>::quiet_NaN();
  }
}

std::size_t RunningSeries::at(double time) const {
  std::size_t k = count_ - 1;
  while (k > 0 && this->time(k) > time) --k;
  return k;
}

}  // namespace tyg

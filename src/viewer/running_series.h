// The last seconds of a few quantities of the running cloth, for plots that run along with it.
// Must not know: what the quantities are, how they are drawn.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tyg {

class RunningSeries {
 public:
  /// `channels` numbers a sample (>= 1), over the last `window` simulated seconds (> 0). All memory is taken here.
  RunningSeries(std::size_t channels, double window);

  /// A sample at `time` (s). Left out are times that are not after the last one (a past that is shown again is known)
  /// and those closer to it than a thousandth of the window.
  void add(double time, std::span<const float> values);
  /// Forgets the samples after this time: the cloth went back, and goes on from there.
  void cut(double time);
  /// A channel that begins anew: what it was is NaN.
  void forget(std::size_t channel);
  void clear() { count_ = 0; }

  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] double window() const { return window_; }
  /// The k-th of the samples, the oldest first.
  [[nodiscard]] double time(std::size_t k) const { return times_[slot(k)]; }
  [[nodiscard]] float value(std::size_t k, std::size_t channel) const { return values_[slot(k) * channels_ + channel]; }
  /// The sample at `time` or last before it, the first one where there is none. size() must not be 0.
  [[nodiscard]] std::size_t at(double time) const;

 private:
  static constexpr std::size_t kMost = 1001;
  [[nodiscard]] std::size_t slot(std::size_t k) const { return (first_ + k) % kMost; }

  std::size_t channels_;
  double window_;
  std::vector<double> times_;
  std::vector<float> values_;
  std::size_t first_ = 0, count_ = 0;
};

}  // namespace tyg

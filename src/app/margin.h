// How far the step of a running cloth is from the largest stable one, followed from frame to frame.
// Must not know: windows, how it is drawn, what the person may do about it.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <string_view>

#include "tyg/simulation.h"

namespace tyg {

/// None: nothing sets a limit. Close: from 0.9 of it. Past: at it or above.
enum class MarginBand : std::uint8_t { None, Fine, Close, Past };

/// A step beside its limit.
struct Margin {
  static constexpr double kClose = 0.9;
  double step = 0;                                          ///< s
  double limit = std::numeric_limits<double>::quiet_NaN();  ///< s; 0: no step holds; NaN or infinite: none
  bool adaptive = false;                                    ///< the method chooses its own steps
  bool live = false;  ///< the limit is that of the present state, not of the sheet at rest
  double cost = 0;    ///< share of the time that finding it took, 0..1

  [[nodiscard]] double share() const { return step / limit; }  ///< of the limit; NaN or 0 where there is none
  [[nodiscard]] MarginBand band() const;
};

using MarginText = std::array<char, 128>;
/// One line such as `0.95 of the limit of 4.26 ms: close to breaking`, and nothing allocated.
void describe(const Margin& margin, MarginText& text);

class MarginWatch {
 public:
  using Clock = std::function<double()>;  ///< s, from any start

  /// Once a frame. Finding the live limit takes no more than a twentieth of the time: the larger a sheet, the fewer
  /// frames look.
  void look(Simulation& simulation, const Clock& clock);
  /// Another simulation: its limit at rest is worked out at the next look.
  void restart() { method_ = nullptr; }
  [[nodiscard]] const Margin& margin() const { return margin_; }
  /// The smaller one of the live limit and that at rest, s: what a safe step keeps away from.
  [[nodiscard]] double certainLimit() const;

 private:
  const Method* method_ = nullptr;
  double rest_ = 0;  ///< s
  Margin margin_;
};

}  // namespace tyg

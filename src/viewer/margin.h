// How far the step of a running cloth is from the largest stable one, followed from frame to frame.
// Must not know: windows, how it is drawn, what the person may do about it.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>

#include "tyg/simulation.h"

namespace tyg {

/// None: nothing sets a limit. Close: from 0.9 of it. Past: at it or above.
enum class MarginBand : std::uint8_t { None, Fine, Close, Past };

/// A step beside its limit.
struct Margin {
  static constexpr double kClose = 0.9;
  double step = 0;  ///< s
  /// s, the smaller one of the limits at rest and in the present state; 0: no step holds; NaN or infinite: none.
  double limit = std::numeric_limits<double>::quiet_NaN();
  double rest = std::numeric_limits<double>::quiet_NaN();  ///< s, of the sheet at rest, likewise
  bool adaptive = false;                                   ///< the method chooses its own steps

  [[nodiscard]] double share() const { return step / limit; }  ///< of the limit; NaN or 0 where there is none
  [[nodiscard]] MarginBand band() const;
};

using MarginText = std::array<char, 128>;
/// One line such as `step is 95 % of the largest stable one (4.26 ms): close to unstable`, and nothing allocated.
void describe(const Margin& margin, MarginText& text);

class MarginWatch {
 public:
  using Clock = std::function<double()>;  ///< s, from any start

  /// Once a frame. Past the alarm of a simulation the limit stays as it was. Finding the live limit takes no more than
  /// a twentieth of the time: the larger a sheet, the fewer frames measure it.
  void update(Simulation& simulation, const Clock& clock);
  /// Finds the live limit now, however long that takes.
  void measure(Simulation& simulation);
  /// The same without a measurement: the last one stays, as long as it is of this method and these live parameters.
  void keep(const Simulation& simulation);
  /// The same for what is chosen for the next run of a frozen cloth, cut as it was. With another method or other live
  /// parameters than at the last update the limit is the one at rest.
  void preview(const Scene& chosen);
  /// Another simulation: its limit at rest is worked out at the next update.
  void restart() { method_ = nullptr; }
  [[nodiscard]] const Margin& margin() const { return margin_; }

 private:
  void follow(const Scene& scene, const Method& method, double step, bool isCut);
  void measureLive(Simulation& simulation, const Clock& clock);

  const Method* method_ = nullptr;
  Scene scene_;                   ///< whose live parameters rest is of
  bool isCut_ = false;            ///< springs are gone: rest is that of whatever may be left
  double live_ = 0;               ///< s
  std::int64_t measuredAt_ = -1;  ///< tick of the last measurement; -1 before the first with this method
  double nextMeasured_ = 0;       ///< s, of the clock
  Margin margin_;
};

}  // namespace tyg

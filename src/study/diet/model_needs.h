// What a scene leaves out: how far its motion is from that of a finer model of the same cloth.
// Must not know: leaner models, words of reports, clocks.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "study/motion/error.h"
#include "study/motion/reference.h"
#include "study/motion/self_crossing.h"

namespace tyg {

/// One refinement and what it changes.
struct Need {
  enum class Kind { Sheet, Step };
  Kind kind = Kind::Sheet;
  std::string words;  ///< such as `sheet 39x39`
  Distance change;    ///< from the scene's motion, m, the largest over the times; NaN: its run failed
  double stretch = 0, finerStretch = 0;  ///< largest of the scene and of the finer one, fractions of the rest length
  /// Is the scene too coarse for an accuracy of `within` m?
  [[nodiscard]] bool tooLean(double within) const { return !(change.rms <= within); }
};

/// Refines once: half the step (a tenth of the tolerance for adaptive methods), and twice the sheet's intervals in each
/// direction, by an adaptive method far below any such change. A single row or column is not refined: its springs are
/// the model itself. Distances are taken up to `upTo` s. `observer` gets the fraction done and may return false: the
/// needs found so far are then given back.
std::vector<Need> needsOf(const Scene& scene, const Reference& reference, double upTo, int threads,
                          const std::function<bool(double fraction)>& observer);

/// When and where a motion first passes through itself, among its sample times up to `upTo` s.
struct FirstCrossing {
  double time = 0;  ///< s
  CrossingCells cells;
};
std::optional<FirstCrossing> firstCrossingOf(const Scene& scene, const SampledMotion& motion, double upTo);

/// Does a sheet hang by particles that have no pinned one beside them? The finer the sheet, the more it stretches
/// there.
bool hangsByPoints(const Scene& scene);

}  // namespace tyg

// The times at which something of a scene begins or ends, besides pushes: winds, the motions of pins and bodies, and
// cuts. A regular type. Must not know: what happens then.
#pragma once

#include <vector>

#include "core/forces/acting.h"
#include "core/simulation/instant.h"
#include "tyg/scene.h"

namespace tyg {

class Timetable {
 public:
  explicit Timetable(const Scene& scene);

  /// The first of the times after now, or `end` where none lies before it, s.
  [[nodiscard]] double nextEdge(const Instant& now, double end) const;
  /// Whether one of the times is now.
  [[nodiscard]] bool isEdge(const Instant& now) const;

 private:
  std::vector<double> edges_;  ///< s, ascending
};

/// The times within a run at which a push, a wind or a motion of its scene begins or ends, each once, ascending, s.
std::vector<double> edgesWithin(const Scene& scene);

/// What of a scene acts from now until the next edge.
Acting actingAt(const Scene& scene, const Instant& now);

}  // namespace tyg

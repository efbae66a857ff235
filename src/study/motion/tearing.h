// Until when it is certain what tears: springs break at once or not at all, so that differences too small to be seen
// decide sooner or later which ones do. Must not know: methods under study, words of reports, clocks.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "study/motion/sampled_motion.h"

namespace tyg {

/// The first sample time (s) at which two motions of one grid have lost different springs; nothing where none is.
std::optional<double> firstTornElsewhere(const SampledMotion& a, const SampledMotion& b);

/// A scene as far as it can be studied.
struct Tearing {
  Scene scene;                    ///< the one given, with a shorter duration where its tears become uncertain
  std::optional<double> differs;  ///< s: there other springs were broken; nothing where the whole scene is certain

  /// One sentence; empty where the whole scene is certain.
  [[nodiscard]] std::string words() const;
};

/// Compares an exact motion of a scene that tears with a twin that starts a little beside it and with a motion whose
/// ticks, at which springs break, are half as long. The scene ends with the last sample before the first difference.
/// A scene that does not tear comes back as it is, at no cost. Throws InputError where no such sample is left.
Tearing untilTearsDiffer(const Scene& scene, int threads, const std::function<bool(double fraction)>& observer);

}  // namespace tyg

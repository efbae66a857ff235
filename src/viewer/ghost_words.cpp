// Distances are judged by the floor, below which the cloth itself has made them out of rounding errors.
#include "viewer/ghost_words.h"

#include <fmt/core.h>

#include "util/amounts.h"

namespace tyg {
namespace {

using Tone = Sentence::Tone;

constexpr double kTellable = 2;  // floors: from there on a distance is more than the reference's own

std::string distanceText(const GhostGap& gap) {
  // Two lines in any case: a panel that follows the length of numbers would never rest.
  return lengthText(gap.rms) + " RMS,\n" + lengthText(gap.largest) + " at most";
}

}  // namespace

Sentence distanceWords(const Ghost& ghost) {
  const std::optional<GhostGap>& gap = ghost.gap();
  if (!gap) return {"distance: ghost not ready yet"};
  if (ghost.behind() <= kNearlyInStep) return {"distance: " + distanceText(*gap)};
  return {fmt::format("distance at {:.2f} s: ", gap->time) + distanceText(*gap)};
}

Sentence meaningWords(const Ghost& ghost) {
  const std::optional<GhostGap>& gap = ghost.gap();
  if (!gap || gap->time == 0) return {};
  const std::string floor = lengthText(gap->floor);
  if (ghost.horizon() == 0) {
    const double since = ghost.comparedSince();
    return {(since > 0 ? fmt::format("Since they first met, at {:.2f} s, the distance", since) : "The distance") +
                " has never been clearly larger than what this cloth makes of rounding errors and of the smallest "
                "differences (" +
                floor + " by now). It means nothing.",
            Tone::Warning};
  }
  if (ghost.horizon() <= gap->time) {
    return {
        fmt::format("The horizon was at {:.2f} s. Since then the cloth has made so much of rounding errors and of the "
                    "smallest differences (",
                    ghost.horizon()) +
            floor + ") that the distance means nothing any more.",
        Tone::Warning};
  }
  if (gap->rms >= kTellable * gap->floor) return {"Below " + floor + ", rounding dominates.", Tone::Dim};
  return {"The two agree as closely as can be measured here: within " + floor + ".", Tone::Good};
}

Sentence progressWords(const Ghost& ghost) {
  if (ghost.status() != Status::Ok) {
    return {fmt::format("The ghost's method failed at {:.3f} s.", ghost.time()), Tone::Warning};
  }
  if (ghost.stalled()) {
    return {fmt::format("The ghost stalled at {:.3f} s: it needed too many steps.", ghost.time()), Tone::Warning};
  }
  if (ghost.behind() <= kNearlyInStep) return {};
  if (!ghost.losing()) {
    return {
        fmt::format("The ghost is catching up: at {:.2f} s of {:.2f} s.", ghost.time(), ghost.time() + ghost.behind())};
  }
  return {
      fmt::format("The ghost is {:.2f} s behind: this machine cannot compute both in time. A pause or slow motion (;) "
                  "lets it catch up.",
                  ghost.behind()),
      Tone::Warning};
}

}  // namespace tyg

// Distances name the sample that they were measured at, because the picture goes on between the samples.
#include "viewer/review_words.h"

#include <fmt/core.h>

#include "util/amounts.h"

namespace tyg {
namespace {

using Tone = Sentence::Tone;

}  // namespace

Sentence verdictSentence(const CheckProgress& check) {
  switch (check.stage) {
    case CheckProgress::Stage::Done:
      return {check.words, check.good ? Tone::Good : Tone::Warning};
    case CheckProgress::Stage::Failed:
      return {"The check is not possible: " + check.words, Tone::Warning};
    case CheckProgress::Stage::Stopped:
      return {"The check was stopped.", Tone::Dim};
    default:
      return {};
  }
}

Sentence otherSceneWords(const MotionReview& review, const Scene& scene) {
  if (review.isOf(scene)) return {};
  return {"The scene is another one than the motion was checked with.", Tone::Warning};
}

Sentence placeWords(const MotionReview& review) {
  const GivenGhost& ghost = review.ghost();
  const std::vector<double>& times = ghost.motion().times;
  switch (ghost.place()) {
    case GivenGhost::Place::Before:
      return {fmt::format("{} begins at {} and is not shown before.", review.name(), timeText(times.front()))};
    case GivenGhost::Place::After:
      return {fmt::format("{} ended at {}: its last positions are shown.", review.name(), timeText(times.back())),
              Tone::Warning};
    case GivenGhost::Place::Within:
      break;
  }
  return {};
}

Sentence gapWords(const GivenGhost& ghost) {
  const std::optional<SampleGap>& gap = ghost.gap();
  if (!gap) return {"distance: measured at the motion's samples"};
  if (!ghost.differs()) {
    return {fmt::format("distance at {:.3f} s: none but by rounding", gap->time), Tone::Good};
  }
  return {fmt::format("distance at {:.3f} s: {} RMS,\n{} at most", gap->time, lengthText(gap->rms),
                      lengthText(gap->largest))};
}

}  // namespace tyg

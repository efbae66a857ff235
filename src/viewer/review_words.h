// What the ghost panel says of a motion that another program wrote: the verdict of its check, where the motion begins
// and ends, and how far the cloth was from it. Must not know: windows, how a motion is checked.
#pragma once

#include "viewer/ghost_words.h"
#include "viewer/motion_review.h"

namespace tyg {

/// What the check found, or why it found nothing; empty while it runs.
Sentence verdictSentence(const CheckProgress& check);
/// Where the check is of another scene than this one; else empty.
Sentence otherSceneWords(const MotionReview& review, const Scene& scene);
/// Why the motion is not to be seen, or why it does not move; empty within its samples.
Sentence placeWords(const MotionReview& review);
/// How far the cloth was from it at its last sample.
Sentence gapWords(const GivenGhost& ghost);

}  // namespace tyg

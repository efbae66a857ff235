// How much lower than they are solid things are drawn, so that they do not hide the lines of a cloth that lies on them:
// particles sink in a little, and the lines between them cut across what is round.
#pragma once

namespace tyg {

inline constexpr float kSink = 0.12F;     ///< m per spacing of the sheet
inline constexpr float kSlantedSink = 2;  ///< pixels, at a slant

}  // namespace tyg

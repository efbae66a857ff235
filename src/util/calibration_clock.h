// The clock that costs of work are measured with.
// Must not know: what is measured.
#pragma once

namespace tyg {

/// s from some start: for one thread the time that the calling thread itself has computed, so that other programs do
/// not count (but on Windows, which counts it coarsely); for more threads the time of day.
double calibrationClock(int threads);
/// s of the time of day, from some start.
double wallClock();

}  // namespace tyg

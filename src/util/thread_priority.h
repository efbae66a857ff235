// Work that may wait for everything else.
// Must not know: what the work is.
#pragma once

namespace tyg {

/// Gives the calling thread the lowest priority. Returns its nice value: 19 where the system allows it.
int lowerThreadPriority();

}  // namespace tyg

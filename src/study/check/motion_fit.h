// Whether a motion that was handed in can be one of a scene at all: its units, where it starts, how long it is.
// Must not know: rows and columns.
#pragma once

#include <string>

#include "study/check/motion_rows.h"

namespace tyg {

/// Throws InputError with `file`, what was found and what is allowed, where the positions are in other units than
/// metres or of another sheet, where the particles do not start where the scene's do, and where times lie beyond the
/// scene's duration.
void refuseOtherMotion(const GivenMotion& motion, const Scene& scene, const std::string& file);

}  // namespace tyg

// What `tyg advise` says: a few lines for people, JSON for scripts.
// Must not know: options, files, how the advice was found.
#pragma once

#include <string>

#include "study/advice/advice.h"

namespace tyg {

/// At most 80 columns wide. `scene` is as it was before the advice.
std::string adviceText(const Scene& scene, const Advice& advice);
/// One JSON object; lengths in m, times in s; numbers that there are not, null.
std::string adviceJson(const Scene& scene, const Advice& advice);
/// What the advised scene's file says in its first lines.
std::string adviceComment(const Scene& scene, const Advice& advice);

}  // namespace tyg

// What `tyg advise` says: a few lines for people, JSON for scripts.
// Must not know: options, files, how the advice was found.
#pragma once

#include <string>

#include "app/reports/device_report.h"
#include "study/advice/advice.h"

namespace tyg {

/// At most 80 columns wide. `scene` is as it was before the advice.
/// `card`: the graphics card that was measured too; cpu: none was.
std::string adviceText(const Scene& scene, const Advice& advice, const DeviceReport& card = {});
/// One JSON object; lengths in m, times in s; numbers that there are not, null.
std::string adviceJson(const Scene& scene, const Advice& advice, const DeviceReport& card = {});
/// What the advised scene's file says in its first lines.
std::string adviceComment(const Scene& scene, const Advice& advice);

}  // namespace tyg

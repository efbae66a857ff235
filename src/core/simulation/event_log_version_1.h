// Lines of event logs of version 1, in which all kinds of events shared nine columns.
// Must not know: the head of a log.
#pragma once

#include "core/simulation/log_lines.h"
#include "tyg/event_log.h"

namespace tyg {

inline constexpr std::string_view kVersion1Columns = "tick,event,particle,fx,fy,fz,ticks,method,dt";

/// Adds the events of the present line to the log: one, or two where the line changes both numbers of a spring family.
/// Throws InputError.
void readVersion1Event(const LogLines& lines, EventLog& log);

}  // namespace tyg

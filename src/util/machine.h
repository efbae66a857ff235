// What this computer calls itself.
// Must not know: what for.
#pragma once

#include <string>

namespace tyg {

/// The model of the processor and the number of its cores, such as `AMD EPYC (2 cores)`; `unknown processor` where the
/// system does not say.
std::string machineName();

}  // namespace tyg

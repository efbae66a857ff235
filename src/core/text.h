// Numbers into text, as printf writes them.
// Must not know: what is written.
#pragma once

#include <string>

namespace tyg {

/// What printf would print, however long.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

}  // namespace tyg

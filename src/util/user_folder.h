// Where a person's own files of a program belong.
// Must not know: what is in them.
#pragma once

#include <filesystem>
#include <optional>

namespace tyg {

/// The folder that this environment variable names, such as XDG_STATE_HOME, or else this one below the person's own,
/// such as .local/state; on Windows always that of local data of programs. Nothing where the system does not say.
std::optional<std::filesystem::path> userFolder(const char* variable, const char* belowHome);

}  // namespace tyg

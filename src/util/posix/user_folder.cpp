// XDG Base Directory Specification.
#include "util/user_folder.h"

#include <cstdlib>

namespace tyg {

std::optional<std::filesystem::path> userFolder(const char* variable, const char* belowHome) {
  if (const char* folder = std::getenv(variable); folder != nullptr && *folder != '\0') return folder;
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0') {
    return std::filesystem::path(home) / belowHome;
  }
  return std::nullopt;
}

}  // namespace tyg

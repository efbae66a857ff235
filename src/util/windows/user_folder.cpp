// One folder holds both settings and what is remembered.
#include "util/user_folder.h"

#include <cstdlib>

namespace tyg {

std::optional<std::filesystem::path> userFolder(const char* /*variable*/, const char* /*belowHome*/) {
  const wchar_t* const folder = _wgetenv(L"LOCALAPPDATA");
  return folder == nullptr || *folder == L'\0' ? std::nullopt : std::optional<std::filesystem::path>(folder);
}

}  // namespace tyg

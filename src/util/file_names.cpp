// See file_names.h.
#include "util/file_names.h"

#include <algorithm>
#include <cctype>

namespace tyg {

std::string fileStem(const std::string& sceneName) { return std::filesystem::path(sceneName).stem().string(); }

std::string endingOf(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return ending;
}

std::filesystem::path freeName(const std::filesystem::path& folder, const std::string& stem,
                               const std::string& ending) {
  std::filesystem::path name = folder / (stem + ending);
  for (int number = 2; std::filesystem::exists(std::filesystem::symlink_status(name)); ++number) {
    std::string numbered = stem;
    name = folder / numbered.append("-").append(std::to_string(number)).append(ending);
  }
  return name;
}

}  // namespace tyg

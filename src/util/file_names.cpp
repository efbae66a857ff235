// Names are tried in order; a name is taken where there is anything, even a link that leads nowhere.
#include "util/file_names.h"

#include <algorithm>
#include <array>
#include <cctype>

#include <fmt/core.h>

#include "util/user_folder.h"

namespace tyg {

std::string fileStem(const std::string& sceneName) { return std::filesystem::path(sceneName).stem().string(); }

std::string endingOf(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return ending;
}

std::string freeStem(const std::filesystem::path& folder, const std::string& stem,
                     std::span<const std::string_view> endings, FirstName first) {
  const auto isTaken = [&](const std::string& name) {
    return std::ranges::any_of(endings, [&](std::string_view ending) {
      return std::filesystem::exists(std::filesystem::symlink_status(folder / fmt::format("{}{}", name, ending)));
    });
  };
  std::string name = first == FirstName::Plain ? stem : stem + "-1";
  for (int number = 2; isTaken(name); ++number) name = fmt::format("{}-{}", stem, number);
  return name;
}

std::filesystem::path freeName(const std::filesystem::path& folder, const std::string& stem,
                               const std::string& ending) {
  const std::array<std::string_view, 1> endings{ending};
  return folder / (freeStem(folder, stem, endings, FirstName::Plain) + ending);
}

std::optional<std::filesystem::path> userFile(const char* variable, const char* belowHome, const char* name) {
  const std::optional<std::filesystem::path> folder = userFolder(variable, belowHome);
  return folder ? std::optional(*folder / "tyg" / name) : std::nullopt;
}

}  // namespace tyg

// The ending tells a motion from a scene: what is wrong with a header of its own can then be said.
#include "viewer/opened_file.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <system_error>
#include <utility>

#include "util/whole_file.h"

namespace tyg {
namespace {

bool endsWith(const std::filesystem::path& path, std::string_view ending) {
  std::string found = path.extension().string();
  std::ranges::transform(found, found.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return found == ending;
}

}  // namespace

OpenedFile readOpened(const std::string& path) {
  OpenedFile file{
      .text = readWholeFile(path, "cannot read", "a scene (.toml), the log of a run or a motion of this scene (.csv)")};
  const bool isLog = file.text.starts_with("# ") && file.text.find("\ntick,event") != std::string::npos;
  file.kind = isLog                    ? OpenedFile::Kind::Log
              : endsWith(path, ".csv") ? OpenedFile::Kind::Motion
                                       : OpenedFile::Kind::Scene;
  return file;
}

std::vector<std::string> openableFiles(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  std::error_code trouble;
  for (std::filesystem::directory_iterator entry(folder, trouble), end; !trouble && entry != end;
       entry.increment(trouble)) {
    const std::filesystem::path& path = entry->path();
    const std::string name = path.filename().string();
    if (!name.starts_with('.') && (endsWith(path, ".toml") || endsWith(path, ".csv"))) names.push_back(name);
  }
  std::ranges::sort(names);
  return names;
}

std::string typedPath(std::string_view text) {
  constexpr std::string_view kAround = " \t\r\n'\"";
  const std::size_t first = text.find_first_not_of(kAround), last = text.find_last_not_of(kAround);
  return first == std::string_view::npos ? "" : std::string(text.substr(first, last - first + 1));
}

}  // namespace tyg

// Files that a person opens in the running window: what they hold, and which ones lie in a folder.
// Must not know: what is done with them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tyg {

struct OpenedFile {
  enum class Kind { Scene, Log, Motion };
  Kind kind = Kind::Scene;
  std::string text;
};
/// Reads a file. A log is known by its first lines, a motion by the ending .csv, and all else is taken for a scene.
/// Throws InputError where it cannot be read.
OpenedFile readOpened(const std::string& path);

/// The names of the .toml and .csv files in a folder, in the order of the alphabet; none where it cannot be read.
std::vector<std::string> openableFiles(const std::filesystem::path& folder);

/// A path as a person types or pastes it, without blanks and quotes around it.
std::string typedPath(std::string_view text);

}  // namespace tyg

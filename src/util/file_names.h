// Names for results that are kept without being asked for a name.
// Must not know: what is in the files.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tyg {

/// A name for results in the current folder: that of the scene without its folder and without .toml.
std::string fileStem(const std::string& sceneName);
/// What follows the last dot, with it, in small letters: `.png` of `A.PNG`.
std::string endingOf(const std::filesystem::path& path);

/// Whether the first of several names is STEM or STEM-1; the second is STEM-2.
enum class FirstName { Plain, Numbered };
/// The first name in this folder that nothing has yet, with any of these endings.
std::string freeStem(const std::filesystem::path& folder, const std::string& stem,
                     std::span<const std::string_view> endings, FirstName first);
/// STEM.ENDING in this folder, or STEM-2.ENDING and so on: the first of these names that nothing has yet.
std::filesystem::path freeName(const std::filesystem::path& folder, const std::string& stem, const std::string& ending);

/// A file of this program in the person's folder of this kind (userFolder() in util/user_folder.h); nothing where there
/// is none.
std::optional<std::filesystem::path> userFile(const char* variable, const char* belowHome, const char* name);

}  // namespace tyg

// A folder of files that appear together or not at all.
// Must not know: what the files are for.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "util/whole_file.h"

namespace tyg {

/// Files are written to a hidden folder first; keep() puts them in their place. Without keep() nothing is left of them.
/// What a process leaves that was killed is removed by the next one that writes the same folder.
class WholeFolder {
 public:
  /// Whether a file of this name that is already in the folder may be replaced or removed.
  using MayReplace = std::function<bool(const std::string& name)>;
  /// Throws InputError where the folder cannot be made or written to, or holds anything that may not be replaced.
  WholeFolder(const std::filesystem::path& path, MayReplace mayReplace);
  ~WholeFolder();
  WholeFolder(const WholeFolder&) = delete;
  WholeFolder& operator=(const WholeFolder&) = delete;

  void write(const std::string& name, std::string_view bytes);  ///< Throws InputError
  /// Puts the files in their places; what was in the folder before is gone. Throws InputError.
  void keep();

 private:
  void checkTarget() const;
  void openTemporary();
  void moveInto();

  std::filesystem::path path_, temporary_;
  MayReplace mayReplace_;
  bool isNew_;
  std::optional<WholeFile> inUse_;  ///< never kept: the lock on it tells others that the hidden folder is in use
};

}  // namespace tyg

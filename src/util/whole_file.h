// Files that are read as a whole, and files that are written whole or not at all.
// Must not know: what the bytes mean.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "util/held_file.h"
#include "util/sudden_end.h"

namespace tyg {

/// All bytes of a file, up to 256 MB of them. Throws InputError: `cannot` ("cannot read the scene"), the path, the
/// reason, and what is `allowed`.
std::string readWholeFile(const std::filesystem::path& path, const std::string& cannot, const std::string& allowed);

/// Writes `bytes` to a temporary file beside `path` and renames it. Throws InputError where that cannot be done;
/// whatever was at `path` before is then still there.
void writeWholeFile(const std::filesystem::path& path, std::string_view bytes);

/// Throws InputError where a file at `path` could not be written: to be called before anything is computed. Leaves no
/// trace.
void checkWritable(const std::filesystem::path& path);

/// For results that come piece by piece, or that another program writes to temporary(): keep() puts the file in its
/// place. Without keep(), and where the process ends before, the temporary file is removed again; what a process leaves
/// that was killed is removed by the next one that writes the same file.
class WholeFile {
 public:
  explicit WholeFile(const std::filesystem::path& path);  ///< Throws InputError as checkWritable does
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  void write(std::string_view bytes);  ///< Throws InputError
  /// Where the file will be: what links lead to.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] const std::filesystem::path& temporary() const { return temporary_; }  ///< same folder and ending
  /// Throws InputError where nothing was written, or where the disk did not take all of it.
  void keep();

 private:
  std::filesystem::path path_, temporary_;
  HeldFile file_;
  std::optional<Unfinished> unfinished_;
  bool kept_ = false;
};

}  // namespace tyg

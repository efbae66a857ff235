// Files that are read as a whole, and files that are written whole or not at all.
// Must not know: what the bytes mean.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

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

/// For results that another program or a library writes piece by piece: write to temporary(), then keep(). Without
/// keep() the temporary file is removed again.
class WholeFile {
 public:
  explicit WholeFile(std::filesystem::path path);  ///< Throws InputError as checkWritable does
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;
  [[nodiscard]] const std::filesystem::path& temporary() const { return temporary_; }  ///< same folder and extension
  void keep();                                                                         ///< Throws InputError

 private:
  std::filesystem::path path_, temporary_;
  bool kept_ = false;
};

}  // namespace tyg

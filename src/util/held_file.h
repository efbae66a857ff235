// A new file that one process holds, so that others can tell a file that is being written from one that a killed
// process has left. Each system has its own way: posix/held_file.cpp, windows/held_file.cpp. Must not know: what is
// written, where it will be in the end.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <system_error>

namespace tyg {

class HeldFile {
 public:
  HeldFile() = default;
  ~HeldFile() { letGo(); }
  HeldFile(const HeldFile&) = delete;
  HeldFile& operator=(const HeldFile&) = delete;

  /// Makes a file that is not there yet. std::errc::file_exists where the name is taken.
  std::error_code create(const std::filesystem::path& path);
  std::error_code write(std::string_view bytes);
  /// Waits until the file is on the disk; `bytes` becomes its size.
  std::error_code flush(std::uint64_t& bytes);
  /// Holds it no longer; the file stays. Windows replaces no file that anybody holds.
  void letGo();

 private:
  static constexpr std::intptr_t kNone = -1;
  std::intptr_t file_ = kNone;
};

/// Removes a file of this person that no process holds any more; does nothing about any other.
void removeUnheld(const std::filesystem::path& path);
/// Why a file that is there may not be written to; no error where it may.
std::error_code whyNotWritable(const std::filesystem::path& path);

}  // namespace tyg

// The holder has the file open. Others may open it too, but not as one that nobody else has open.
#include "util/held_file.h"

#include <windows.h>

#include <algorithm>

namespace tyg {
namespace {

namespace fs = std::filesystem;

std::error_code lastError() { return {int(GetLastError()), std::system_category()}; }

HANDLE handleOf(std::intptr_t file) { return reinterpret_cast<HANDLE>(file); }

}  // namespace

void HeldFile::letGo() {
  if (file_ != kNone) CloseHandle(handleOf(file_));
  file_ = kNone;
}

std::error_code HeldFile::create(const fs::path& path) {
  constexpr DWORD kShared = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
  const HANDLE file =
      CreateFileW(path.c_str(), GENERIC_WRITE, kShared, nullptr, CREATE_NEW, FILE_ATTRIBUTE_NORMAL, nullptr);
  if (file == INVALID_HANDLE_VALUE) {
    return GetLastError() == ERROR_FILE_EXISTS ? std::make_error_code(std::errc::file_exists) : lastError();
  }
  file_ = reinterpret_cast<std::intptr_t>(file);
  return {};
}

std::error_code HeldFile::write(std::string_view bytes) {
  constexpr std::size_t kAtOnce = std::size_t{1} << 24U;
  while (!bytes.empty()) {
    DWORD written = 0;
    const auto count = DWORD(std::min(bytes.size(), kAtOnce));
    if (WriteFile(handleOf(file_), bytes.data(), count, &written, nullptr) == 0) return lastError();
    bytes.remove_prefix(written);
  }
  return {};
}

std::error_code HeldFile::flush(std::uint64_t& bytes) {
  LARGE_INTEGER size{};
  if (FlushFileBuffers(handleOf(file_)) == 0 || GetFileSizeEx(handleOf(file_), &size) == 0) return lastError();
  bytes = std::uint64_t(size.QuadPart);
  return {};
}

void removeUnheld(const fs::path& path) {
  constexpr DWORD kNotShared = 0;
  const HANDLE file = CreateFileW(path.c_str(), GENERIC_READ | DELETE, kNotShared, nullptr, OPEN_EXISTING,
                                  FILE_FLAG_DELETE_ON_CLOSE, nullptr);
  if (file != INVALID_HANDLE_VALUE) CloseHandle(file);
}

std::error_code whyNotWritable(const fs::path& path) {
  constexpr DWORD kShared = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
  const HANDLE file = CreateFileW(path.c_str(), GENERIC_WRITE, kShared, nullptr, OPEN_EXISTING, 0, nullptr);
  if (file == INVALID_HANDLE_VALUE) return lastError();
  CloseHandle(file);
  return {};
}

}  // namespace tyg

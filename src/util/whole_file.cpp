// Writing goes to a temporary file in the same folder, which is renamed when it is complete.
#include "util/whole_file.h"

#include <array>
#include <cerrno>
#include <cstdint>
#include <fstream>
#include <random>
#include <system_error>
#include <utility>

#include <unistd.h>

#include <fmt/core.h>

#include "tyg/input_error.h"

namespace tyg {
namespace {

namespace fs = std::filesystem;

/// More than any log or table of Tyg has.
constexpr std::size_t kMostBytesRead = 256 << 20;

[[noreturn]] void refuse(const fs::path& path, const std::string& found) {
  throw InputError("cannot write '" + path.string() + "': " + found +
                   "; allowed: a file in a folder that exists and may be written to");
}

std::string lastSystemError() { return std::generic_category().message(errno); }

fs::path folderOf(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

/// A symbolic link stays a link: what it points to is replaced, or made where it is not there yet.
fs::path behindLink(fs::path path) {
  constexpr int kMostLinks = 40;  // one behind the other, as for the system
  std::error_code none;
  for (int k = 0; k < kMostLinks && fs::is_symlink(path, none); ++k)
    path = folderOf(path) / fs::read_symlink(path, none);
  return path;
}

/// The name does not grow with the file's own, which may already be as long as the system allows.
fs::path temporaryBeside(const fs::path& path) {
  std::random_device random;
  const std::uint64_t number = (std::uint64_t{random()} << 32U) | random();
  return folderOf(path) / (".tyg-" + std::to_string(number) + path.extension().string());
}

/// What is there already must be a plain file: a rename would replace a device such as /dev/null for good.
void checkTarget(const fs::path& path) {
  if (path.empty()) refuse(path, "no name was given");
  std::error_code error;
  const fs::path folder = folderOf(path);
  const fs::file_status folderStatus = fs::status(folder, error);
  if (!fs::exists(folderStatus)) {
    refuse(path, "the folder '" + folder.string() + "' cannot be found (" + error.message() + ")");
  }
  if (!fs::is_directory(folderStatus)) refuse(path, "'" + folder.string() + "' is not a folder");
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status) || !path.has_filename()) refuse(path, "it names a folder");
  if (!fs::exists(status)) return;
  if (!fs::is_regular_file(status)) refuse(path, "it is there and is not a plain file");
  if (::access(path.c_str(), W_OK) != 0) refuse(path, lastSystemError());
}

void createAndRemove(const fs::path& path, const fs::path& temporary) {
  if (!std::ofstream(temporary, std::ios::binary)) refuse(path, lastSystemError());
  std::error_code ignored;
  fs::remove(temporary, ignored);
}

}  // namespace

std::string readWholeFile(const fs::path& path, const std::string& cannot, const std::string& allowed) {
  const auto refuse = [&](const std::string& found) {
    throw InputError(fmt::format("{} '{}': {}; allowed: {}", cannot, path.string(), found, allowed));
  };
  std::error_code error;
  if (fs::is_directory(path, error)) refuse("it is a folder");
  std::ifstream in(path, std::ios::binary);
  if (!in) refuse(lastSystemError());
  // In pieces: a device or a pipe may never end.
  std::string text;
  std::array<char, 1 << 16> piece{};
  while (in.read(piece.data(), piece.size()) || in.gcount() > 0) {
    text.append(piece.data(), static_cast<std::size_t>(in.gcount()));
    if (text.size() > kMostBytesRead) refuse(fmt::format("it has more than {} bytes", kMostBytesRead));
  }
  if (in.bad()) refuse("reading failed");
  return text;
}

void writeWholeFile(const fs::path& path, std::string_view bytes) {
  WholeFile file(path);
  std::ofstream out(file.temporary(), std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) refuse(path, lastSystemError());
  file.keep();
}

void checkWritable(const fs::path& path) { const WholeFile file(path); }

WholeFile::WholeFile(fs::path path) : path_(behindLink(std::move(path))), temporary_(temporaryBeside(path_)) {
  checkTarget(path_);
  createAndRemove(path_, temporary_);
}

WholeFile::~WholeFile() {
  if (kept_) return;
  std::error_code ignored;
  fs::remove(temporary_, ignored);
}

void WholeFile::keep() {
  std::error_code error;
  fs::rename(temporary_, path_, error);
  if (error) refuse(path_, error.message());
  kept_ = true;
}

}  // namespace tyg

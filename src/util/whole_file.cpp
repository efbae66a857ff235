// Writing goes to a temporary file in the same folder, which is renamed when it is complete. Its name follows from the
// file's own, so that the next run finds what a killed one has left. Who writes to it holds it.
#include "util/whole_file.h"

#include <array>
#include <cerrno>
#include <fstream>
#include <functional>
#include <system_error>
#include <utility>

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
fs::path behindLink(const fs::path& link) {
  constexpr int kMostLinks = 40;  // one behind the other, as for the system
  fs::path path = link;
  std::error_code none;
  for (int k = 0; fs::is_symlink(path, none); ++k) {
    if (k == kMostLinks) refuse(link, "it is a link that leads back to itself");
    path = folderOf(path) / fs::read_symlink(path, none);
  }
  return path;
}

/// The name does not grow with the file's own, which may already be as long as the system allows.
fs::path temporaryBeside(const fs::path& path, int number) {
  constexpr std::size_t kLongestEnding = 8;
  const std::string ending = path.extension().string();
  return folderOf(path) / fmt::format(".tyg-{:016x}-{}{}", std::hash<std::string>{}(path.filename().string()), number,
                                      ending.size() <= kLongestEnding ? ending : "");
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
  if (status.type() == fs::file_type::not_found) return;
  if (!fs::status_known(status)) refuse(path, error.message());
  if (!fs::is_regular_file(status)) refuse(path, "it is there and is not a plain file");
  if (const std::error_code why = whyNotWritable(path)) refuse(path, why.message());
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
  file.write(bytes);
  file.keep();
}

void checkWritable(const fs::path& path) { const WholeFile file(path); }

WholeFile::WholeFile(const fs::path& path) : path_(behindLink(path)) {
  constexpr int kMostWriters = 1000;  // of one file at the same time
  checkTarget(path_);
  std::error_code error = std::make_error_code(std::errc::file_exists);
  for (int number = 1; error == std::errc::file_exists && number <= kMostWriters; ++number) {
    temporary_ = temporaryBeside(path_, number);
    removeUnheld(temporary_);
    error = file_.create(temporary_);
  }
  if (error) refuse(path_, error.message());
  unfinished_.emplace(temporary_);
}

WholeFile::~WholeFile() {
  std::error_code none;
  if (!kept_) fs::remove(temporary_, none);
}

void WholeFile::write(std::string_view bytes) {
  if (const std::error_code error = file_.write(bytes)) refuse(path_, error.message());
}

void WholeFile::keep() {
  std::uint64_t size = 0;
  std::error_code error = file_.flush(size);
  if (error) refuse(path_, error.message());
  if (size == 0) refuse(path_, "nothing was written to it");
  fs::rename(temporary_, path_, error);
  if (error) refuse(path_, error.message());
  file_.letGo();
  kept_ = true;
}

}  // namespace tyg

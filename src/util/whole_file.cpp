// Writing goes to a temporary file in the same folder, which is renamed when it is complete. Its name follows from the
// file's own, so that the next run finds what a killed one has left. Who writes to it holds a lock on it, which the
// system takes away with the process.
#include "util/whole_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

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

bool isFile(int descriptor, const fs::path& path) {
  struct stat opened {
  }, named{};
  return fstat(descriptor, &opened) == 0 && lstat(path.c_str(), &named) == 0 && S_ISREG(named.st_mode) &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

bool isOwn(int descriptor) {
  struct stat opened {};
  return fstat(descriptor, &opened) == 0 && opened.st_uid == geteuid();
}

/// Removes a temporary file of this person that no process is writing to any more.
void removeStale(const fs::path& temporary) {
  const int descriptor = open(temporary.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return;
  const bool isStale = isOwn(descriptor) && flock(descriptor, LOCK_EX | LOCK_NB) == 0;
  if (isStale && isFile(descriptor, temporary)) unlink(temporary.c_str());
  close(descriptor);
}

/// Makes a temporary file that nobody else uses, and locks it; -1 where its name is taken.
int createLocked(const fs::path& temporary) {
  const int descriptor = open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (descriptor < 0) return -1;
  (void)flock(descriptor, LOCK_EX);  // some file systems have no locks: nothing is cleared there
  if (isFile(descriptor, temporary)) return descriptor;
  close(descriptor);  // somebody took it for a stale one before it was locked
  errno = EEXIST;
  return -1;
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
  if (::access(path.c_str(), W_OK) != 0) refuse(path, lastSystemError());
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
  for (int number = 1; descriptor_ < 0 && number <= kMostWriters; ++number) {
    temporary_ = temporaryBeside(path_, number);
    removeStale(temporary_);
    descriptor_ = createLocked(temporary_);
    if (descriptor_ < 0 && errno != EEXIST) break;
  }
  if (descriptor_ < 0) refuse(path_, lastSystemError());
  unfinished_.emplace(temporary_);
}

WholeFile::~WholeFile() {
  if (!kept_) ::unlink(temporary_.c_str());
  unfinished_.reset();
  close(descriptor_);
}

void WholeFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) refuse(path_, lastSystemError());
    bytes.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
  }
}

void WholeFile::keep() {
  struct stat written {};
  const bool isOnDisk = fsync(descriptor_) == 0 || errno == EINVAL;  // no such thing on some file systems
  if (!isOnDisk || fstat(descriptor_, &written) != 0) refuse(path_, lastSystemError());
  if (written.st_size == 0) refuse(path_, "nothing was written to it");
  std::error_code error;
  fs::rename(temporary_, path_, error);
  if (error) refuse(path_, error.message());
  kept_ = true;
}

}  // namespace tyg

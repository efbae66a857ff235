// The holder has a lock on the file, which the system takes away with the process.
#include "util/held_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

namespace tyg {
namespace {

namespace fs = std::filesystem;

std::error_code lastError() { return {errno, std::generic_category()}; }

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

}  // namespace

void HeldFile::letGo() {
  if (file_ != kNone) close(int(file_));
  file_ = kNone;
}

std::error_code HeldFile::create(const fs::path& path) {
  const int descriptor = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (descriptor < 0) return lastError();
  (void)flock(descriptor, LOCK_EX);  // some file systems have no locks: nothing is cleared there
  if (!isFile(descriptor, path)) {   // somebody took it for an unheld one before it was locked
    close(descriptor);
    return std::make_error_code(std::errc::file_exists);
  }
  file_ = descriptor;
  return {};
}

std::error_code HeldFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(int(file_), bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) return lastError();
    bytes.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
  }
  return {};
}

std::error_code HeldFile::flush(std::uint64_t& bytes) {
  struct stat written {};
  const bool isOnDisk = fsync(int(file_)) == 0 || errno == EINVAL;  // no such thing on some file systems
  if (!isOnDisk || fstat(int(file_), &written) != 0) return lastError();
  bytes = std::uint64_t(written.st_size);
  return {};
}

void removeUnheld(const fs::path& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return;
  const bool isUnheld = isOwn(descriptor) && flock(descriptor, LOCK_EX | LOCK_NB) == 0;
  if (isUnheld && isFile(descriptor, path)) unlink(path.c_str());
  close(descriptor);
}

std::error_code whyNotWritable(const fs::path& path) {
  return ::access(path.c_str(), W_OK) == 0 ? std::error_code() : lastError();
}

}  // namespace tyg

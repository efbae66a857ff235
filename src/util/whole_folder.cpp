// A folder that is not there yet is written beside its place and renamed. One that is there keeps its place, for it may
// be where the person is: its files are written to a folder inside it and then moved, one quick rename each.
#include "util/whole_folder.h"

#include <system_error>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "tyg/input_error.h"

namespace tyg {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHidden = ".tyg-folder-";

[[noreturn]] void refuse(const fs::path& path, const std::string& found) {
  throw InputError("cannot write the folder '" + path.string() + "': " + found +
                   "; allowed: a folder that is not there yet, that is empty, or that holds an earlier result alone");
}

fs::path withoutLastSlash(const fs::path& path) { return path.has_filename() ? path : path.parent_path(); }

fs::path parentOf(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

std::vector<fs::path> entriesOf(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> entries;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    entries.push_back(entry->path());
  }
  if (error) refuse(folder, error.message());
  return entries;
}

bool isHidden(const fs::path& path) { return path.filename().string().starts_with(kHidden); }

/// Whether nobody has its lock any more.
bool isStale(const fs::path& lock) {
  const WholeFile mine(lock);
  return mine.temporary().stem().string().ends_with("-1");  // the first name that there is for it
}

}  // namespace

WholeFolder::WholeFolder(const fs::path& path, MayReplace mayReplace)
    : path_(withoutLastSlash(path)), mayReplace_(std::move(mayReplace)), isNew_(!fs::exists(path_)) {
  checkTarget();
  openTemporary();
}

void WholeFolder::checkTarget() const {
  std::error_code none;
  if (path_.empty()) refuse(path_, "no name was given");
  if (isNew_ && !fs::is_directory(parentOf(path_), none)) {
    refuse(path_, "the folder '" + parentOf(path_).string() + "' cannot be found");
  }
  if (isNew_) return;
  if (!fs::is_directory(path_, none)) refuse(path_, "it is there and is not a folder");
  for (const fs::path& entry : entriesOf(path_)) {
    const std::string name = entry.filename().string();
    if (!isHidden(entry) && !mayReplace_(name)) refuse(path_, "it holds '" + name + "'");
  }
}

void WholeFolder::openTemporary() {
  constexpr int kMostWriters = 100;  // of one folder at the same time
  const std::string name = kHidden + (isNew_ ? path_.filename().string() : std::string());
  std::error_code error;
  for (int number = 1; number <= kMostWriters; ++number) {
    temporary_ = (isNew_ ? parentOf(path_) : path_) / fmt::format("{}-{}", name, number);
    const fs::path lock = temporary_ / "in-use";
    if (fs::is_directory(temporary_, error) && isStale(lock)) fs::remove_all(temporary_, error);
    if (!fs::create_directory(temporary_, error)) {
      if (error) break;
      continue;
    }
    inUse_.emplace(lock);
    return;
  }
  refuse(path_, error ? error.message() : "others write to it");
}

WholeFolder::~WholeFolder() {
  const bool isKept = !inUse_;
  if (isKept) return;
  inUse_.reset();
  std::error_code none;
  fs::remove_all(temporary_, none);
}

void WholeFolder::write(const std::string& name, std::string_view bytes) { writeWholeFile(temporary_ / name, bytes); }

void WholeFolder::keep() {
  checkTarget();
  inUse_.reset();
  std::error_code error;
  if (isNew_) {
    fs::rename(temporary_, path_, error);
  } else {
    moveInto();
  }
  std::error_code none;
  fs::remove_all(temporary_, none);
  if (error) refuse(path_, error.message());
}

void WholeFolder::moveInto() {
  for (const fs::path& entry : entriesOf(path_)) {
    if (!isHidden(entry)) fs::remove(entry);
  }
  for (const fs::path& entry : entriesOf(temporary_)) fs::rename(entry, path_ / entry.filename());
}

}  // namespace tyg

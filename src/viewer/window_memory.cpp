// A line of the file is a name, an equals sign between spaces, and a word.
#include "viewer/window_memory.h"

#include <algorithm>
#include <exception>

#include "util/file_names.h"
#include "util/whole_file.h"

namespace tyg {
namespace {

constexpr std::string_view kIs = " = ";

}  // namespace

std::optional<std::filesystem::path> windowMemoryFile() { return userFile("XDG_CONFIG_HOME", ".config", "window"); }

WindowMemory::WindowMemory(std::optional<std::filesystem::path> file) : file_(std::move(file)) {
  std::error_code ignored;
  if (!file_ || !std::filesystem::exists(*file_, ignored)) return;
  try {
    if (read(readWholeFile(*file_, "cannot read", "a file of what the window remembers"))) return;
  } catch (const std::exception&) {  // it is there, and cannot be read
  }
  words_.clear();
  complain();
}

bool WindowMemory::read(std::string_view text) {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    const std::size_t is = line.find(kIs);
    if (is == std::string_view::npos) return false;
    words_[std::string(line.substr(0, is))] = line.substr(is + kIs.size());
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return true;
}

void WindowMemory::complain() { trouble_ = file_->string() + " is not as this window writes it, and is ignored."; }

std::optional<std::string> WindowMemory::find(std::string_view name) const {
  const auto found = words_.find(name);
  return found == words_.end() ? std::nullopt : std::optional(found->second);
}

void WindowMemory::refuse(std::string_view name) {
  words_.erase(std::string(name));
  complain();
}

void WindowMemory::keep(std::string_view name, const std::string& word) {
  if (!file_ || find(name) == word) return;
  words_[std::string(name)] = word;
  std::string text;
  for (const auto& [each, is] : words_) text.append(each).append(kIs).append(is).append("\n");
  try {
    std::filesystem::create_directories(file_->parent_path());
    writeWholeFile(*file_, text);
  } catch (const std::exception&) {  // the next window opens as ever, no more
  }
}

}  // namespace tyg

// The hints that were seen are kept in a small file, one name a line.
#include "viewer/hints.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string>

#include "util/file_names.h"
#include "util/whole_file.h"

namespace tyg {
namespace {

struct Hint {
  std::string_view name, text;
};
constexpr std::array<Hint, 4> kHints{
    Hint{"push", "A click on the cloth pushes it, and a drag grabs it."},
    Hint{"tools", "The left button has three tools: F2 pushes and grabs, F3 pins, F4 cuts."},
    Hint{"chart", "C shows a chart of how fast and how accurate every method is in this scene."},
    Hint{"ghost", "G shows where the cloth would be if it were computed without errors."},
};
constexpr std::string_view kOldPush = "poke";  // what files of earlier versions call the first one

}  // namespace

std::optional<std::filesystem::path> hintsFile() { return userFile("XDG_STATE_HOME", ".local/state", "hints"); }

Hints::Hints(std::optional<std::filesystem::path> file) : file_(std::move(file)) {
  static_assert(kHints.size() == kCount);
  if (!file_) {
    std::ranges::fill(seen_, true);
    return;
  }
  std::string text;
  try {
    text = "\n" + readWholeFile(*file_, "cannot read the hints", "any file");
  } catch (const std::exception&) {  // there is none yet, or it cannot be read
    return;
  }
  for (std::size_t k = 0; k < kCount; ++k) {
    const auto listed = [&text](std::string_view name) { return text.find(fmt::format("\n{}\n", name)) != text.npos; };
    seen_[k] = listed(kHints[k].name) || (k == 0 && listed(kOldPush));
  }
}

std::string_view Hints::show(double now) {
  const auto* const next = std::ranges::find(seen_, false);
  if (next == std::end(seen_)) return {};
  const auto hint = static_cast<std::size_t>(next - std::begin(seen_));
  if (!since_) since_ = now;
  if (now - *since_ <= kSeconds) return kHints.at(hint).text;
  seen(hint);
  return {};
}

void Hints::did(Topic topic) {
  if (!seen_[static_cast<std::size_t>(topic)]) seen(static_cast<std::size_t>(topic));
}

void Hints::seen(std::size_t hint) {
  seen_[hint] = true;
  since_.reset();
  std::string text;
  for (std::size_t k = 0; k < kCount; ++k) {
    if (seen_[k]) text.append(kHints.at(k).name).append("\n");
  }
  try {
    std::filesystem::create_directories(file_->parent_path());
    writeWholeFile(*file_, text);
  } catch (const std::exception&) {  // they come again next time, no more
  }
}

}  // namespace tyg

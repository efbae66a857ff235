// Four hints for newcomers, each shown once and never again. Must not know: how they are drawn.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string_view>

namespace tyg {

/// Where what a person has seen is remembered: XDG_STATE_HOME/tyg/hints, else HOME/.local/state/tyg/hints; nothing
/// where neither is set.
std::optional<std::filesystem::path> hintsFile();

class Hints {
 public:
  enum class Topic { Push, Tools, Chart, Ghost };
  static constexpr double kSeconds = 20;  ///< that a hint stays when nobody follows it

  /// Hints that `file` says were seen are not shown. Nothing: none at all. A file that cannot be read or written costs
  /// no more than hints that come again.
  explicit Hints(std::optional<std::filesystem::path> file);

  /// The hint to show, empty where there is none. `now`, s, of any clock: from its first showing on a hint ages.
  std::string_view show(double now);
  /// The person has done what a hint is about, which then is not needed.
  void did(Topic topic);

 private:
  static constexpr std::size_t kCount = 4;
  void seen(std::size_t hint);

  std::optional<std::filesystem::path> file_;
  bool seen_[kCount] = {};
  std::optional<double> since_;  ///< s, of the first showing of the present hint
};

}  // namespace tyg

// Another program at work for this one: it is fed through its standard input, and all that it prints is read.
// Must not know: which program it is, what its words mean.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tyg {

/// Is there a program of this name on the PATH?
bool isOnPath(const std::string& program);

/// A running program. It is in a process group of its own, so that Ctrl-C in a terminal reaches this program alone,
/// which then decides what becomes of it. It is killed where this program ends before it.
class ChildProcess {
 public:
  /// How it came to its end.
  struct Ending {
    enum class Kind { ByItself, Stopped, TooLate };
    Kind kind = Kind::ByItself;
    int status = -1;  ///< its exit status; -1 where a signal ended it
    [[nodiscard]] bool good() const { return kind == Kind::ByItself && status == 0; }
  };

  /// Starts `words[0]`, which is looked for on the PATH, with the other words as its arguments; no shell is involved.
  /// It runs in `folder`; an empty path means this program's own folder. `stop` is asked at least ten times a second
  /// whether it is to be waited for no longer. Throws std::system_error: its code is ENOENT where there is no such
  /// program.
  explicit ChildProcess(
      const std::vector<std::string>& words, const std::filesystem::path& folder = {},
      std::function<bool()> stop = [] { return false; });
  /// Kills the program, and all that it has started, where wait() has not seen its end.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Feeds these bytes to its standard input. Returns false where it has ended, where `stop` says so, and where it
  /// takes nothing for so many seconds. What it prints meanwhile is read, so that neither program waits for the other.
  bool write(std::string_view bytes, double seconds);
  /// Ends its standard input, reads what it still prints, and waits for its end. It is killed where that takes longer
  /// than so many seconds, or as soon as `stop` says so. To be called once.
  Ending wait(double seconds);
  /// What it has printed so far, on standard output and standard error; of more than 4 MiB the beginning.
  [[nodiscard]] const std::string& printed() const;

 private:
  struct Impl;  ///< posix/child_process.cpp, windows/child_process.cpp
  std::unique_ptr<Impl> impl_;
};

}  // namespace tyg

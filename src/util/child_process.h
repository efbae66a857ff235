// Another program at work for this one: it is fed through its standard input, and all that it prints is read.
// Must not know: which program it is, what its words mean.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <sys/types.h>

namespace tyg {

/// Is there a program of this name on the PATH?
bool isOnPath(const std::string& program);

/// A running program. It is in a process group of its own, so that Ctrl-C in a terminal reaches this program alone,
/// which then decides what becomes of it.
class ChildProcess {
 public:
  /// Starts `words[0]`, which is looked for on the PATH, with the other words as its arguments; no shell is involved.
  /// It runs in `folder`; an empty path means this program's own folder. Throws std::system_error: its code is ENOENT
  /// where there is no such program.
  explicit ChildProcess(const std::vector<std::string>& words, const std::filesystem::path& folder = {});
  /// Kills the program, and all that it has started, where wait() has not seen its end.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Feeds these bytes to its standard input. Returns false where it has ended. What it prints meanwhile is read,
  /// so that neither program waits for the other.
  bool write(std::string_view bytes);
  /// Ends its standard input, reads what it still prints, and waits for its end. It is killed as soon as `stop` says
  /// so, which is asked at least ten times a second. Returns its exit status, or -1 where a signal ended it. To be
  /// called once.
  int wait(const std::function<bool()>& stop = [] { return false; });
  /// All that it has printed so far, on standard output and standard error.
  [[nodiscard]] const std::string& printed() const { return printed_; }

 private:
  bool readSome();
  void kill() const;
  int reap();

  pid_t pid_ = 0;    // 0 once its end was seen
  int socket_ = -1;  // the other end is its standard input, output and error
  std::string printed_;
};

}  // namespace tyg

// What has to happen where the process ends before its work does: unfinished files are removed and programs that it
// has started are ended, whether a signal, exit() inside a library or a fault ends it. Must not know: what is in the
// files.
#pragma once

#include <filesystem>
#include <functional>

namespace tyg {

/// From now on the rule of this file holds for every signal but SIGKILL, unless the program was started with the signal
/// ignored. A file that grows beyond the limit of the process is an error of writing and no longer a signal.
/// It may be called again.
void prepareForSuddenEnd();

/// From now on writing to a pipe that nobody reads any more fails, and is no signal that ends the process.
void ignoreClosedPipes();

/// A program that was started, and all that it starts, by the number that the system has for them.
struct ProcessGroup {
  int number = 0;
};

/// While one of these lives, the file or the program does not outlive the process. (Windows itself ends programs with
/// the one that has started them; see windows/child_process.cpp.)
class Unfinished {
 public:
  explicit Unfinished(const std::filesystem::path& file);
  explicit Unfinished(ProcessGroup group);
  ~Unfinished();
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;

 private:
  int slot_ = -1;
};

/// While it lives, `work` is done where somebody calls exit() below, as Xlib does when its display has gone. The
/// process then ends with exit code 1 and without further clean-up.
class AtExit {
 public:
  explicit AtExit(std::function<void()> work);
  ~AtExit();
  AtExit(const AtExit&) = delete;
  AtExit& operator=(const AtExit&) = delete;
};

/// Removes and ends what is unfinished, and then lets the signal end the process. To be called in a handler of signals.
void endBySignal(int signal);

}  // namespace tyg

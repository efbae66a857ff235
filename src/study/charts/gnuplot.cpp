// gnuplot as a child process.
#include "study/charts/gnuplot.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace tyg {
namespace {

/// What the child gets instead of this process's files and folder.
class ChildSetup {
 public:
  ChildSetup(const std::filesystem::path& folder, int output) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, output, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, output, STDERR_FILENO);
    posix_spawn_file_actions_addchdir_np(&actions_, folder.empty() ? "." : folder.c_str());
  }
  ~ChildSetup() { posix_spawn_file_actions_destroy(&actions_); }
  ChildSetup(const ChildSetup&) = delete;
  ChildSetup& operator=(const ChildSetup&) = delete;
  [[nodiscard]] const posix_spawn_file_actions_t* actions() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

std::string readAll(int file) {
  std::string text;
  std::array<char, 4096> buffer{};
  for (;;) {
    const ssize_t count = read(file, buffer.data(), buffer.size());
    if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
    if (count == 0 || (count < 0 && errno != EINTR)) return text;
  }
}

std::string statements(const std::vector<std::string>& definitions) {
  std::string text;
  for (const std::string& definition : definitions) text += definition + ";";
  return text;
}

bool endedWell(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) return false;
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

GnuplotOutcome runGnuplot(const std::filesystem::path& folder, const std::string& script,
                          const std::vector<std::string>& definitions) {
  std::array<std::string, 4> words{"gnuplot", "-e", statements(definitions), script};
  std::array<char*, 5> arguments{words[0].data(), words[1].data(), words[2].data(), words[3].data(), nullptr};

  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    return {GnuplotOutcome::Kind::Failed, std::generic_category().message(errno)};
  }
  pid_t child = 0;
  const int error =
      posix_spawnp(&child, "gnuplot", ChildSetup(folder, ends[1]).actions(), nullptr, arguments.data(), environ);
  close(ends[1]);
  const std::string said = error == 0 ? readAll(ends[0]) : std::generic_category().message(error);
  close(ends[0]);
  if (error != 0) return {error == ENOENT ? GnuplotOutcome::Kind::Missing : GnuplotOutcome::Kind::Failed, said};
  return {endedWell(child) ? GnuplotOutcome::Kind::Drawn : GnuplotOutcome::Kind::Failed, said};
}

std::string gnuplotQuoted(const std::string& text) {
  std::string quoted = "'";
  for (const char character : text) quoted += character == '\'' ? "''" : std::string(1, character);
  return quoted + "'";
}

std::string chartColour(std::size_t k) {
  constexpr std::array<const char*, 7> kColours{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                "#E69F00", "#56B4E9", "#000000"};
  return kColours.at(k % kColours.size());
}

}  // namespace tyg

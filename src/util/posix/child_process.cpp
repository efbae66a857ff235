// POSIX processes. One socket carries both directions: unlike a pipe it can be written to without waiting and without
// the signal that would end this program when the other one has gone.
#include "util/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <optional>
#include <system_error>

#include "util/sudden_end.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves declaring it to the program

namespace tyg {
namespace {

void mustBeZero(int error) {
  if (error != 0) throw std::system_error(error, std::generic_category());
}

/// What the program gets instead of this one's files, folder and process group.
class Setup {
 public:
  Setup(int socket, const std::filesystem::path& folder) {
    posix_spawn_file_actions_init(&actions_);
    for (const int file : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
      posix_spawn_file_actions_adddup2(&actions_, socket, file);
    }
    if (!folder.empty()) posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP);
  }
  ~Setup() {
    posix_spawnattr_destroy(&attributes_);
    posix_spawn_file_actions_destroy(&actions_);
  }
  Setup(const Setup&) = delete;
  Setup& operator=(const Setup&) = delete;

  [[nodiscard]] int spawn(pid_t& pid, std::vector<std::string> words) const {
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    return posix_spawnp(&pid, arguments.front(), &actions_, &attributes_, arguments.data(), environ);
  }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

using Clock = std::chrono::steady_clock;

Clock::time_point after(double seconds) {
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

constexpr int kTenthOfASecond = 100, kHundredthOfASecond = 10;  // ms
constexpr std::size_t kMostPrinted = std::size_t{4} << 20U;     // bytes

/// Which of the `events` the socket is ready for; none where that takes longer than `milliseconds`.
short awaited(int socket, short events, int milliseconds) {
  pollfd entry{.fd = socket, .events = events, .revents = 0};
  return poll(&entry, 1, milliseconds) > 0 ? entry.revents : short{0};
}

}  // namespace

bool isOnPath(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::string_view folders = path == nullptr ? "" : path;
  while (!folders.empty()) {
    const std::size_t colon = std::min(folders.find(':'), folders.size());
    if (access((std::filesystem::path(folders.substr(0, colon)) / program).c_str(), X_OK) == 0) return true;
    folders.remove_prefix(std::min(colon + 1, folders.size()));
  }
  return false;
}

struct ChildProcess::Impl {
  std::function<bool()> stop;
  pid_t pid = 0;    // 0 once its end was seen
  int socket = -1;  // the other end is its standard input, output and error
  int status = -1;
  std::optional<Unfinished> running{};
  std::string printed{};

  ~Impl() {
    if (pid != 0) end();
    if (socket >= 0) close(socket);
  }

  bool readSome();
  bool hasEnded();
  void end();
  void forget(int ending);
};

ChildProcess::ChildProcess(const std::vector<std::string>& words, const std::filesystem::path& folder,
                           std::function<bool()> stop)
    : impl_(new Impl{.stop = std::move(stop)}) {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) mustBeZero(errno);
  impl_->socket = ends[0];
  pid_t pid = 0;
  const int error = Setup(ends[1], folder).spawn(pid, words);
  close(ends[1]);
  mustBeZero(error);
  impl_->pid = pid;
  impl_->running.emplace(ProcessGroup{pid});
}

ChildProcess::~ChildProcess() = default;

const std::string& ChildProcess::printed() const { return impl_->printed; }

/// Takes what is there to be read, waiting for it if need be. Returns false where nothing will come any more.
bool ChildProcess::Impl::readSome() {
  std::array<char, 4096> buffer{};
  const ssize_t count = recv(socket, buffer.data(), buffer.size(), 0);
  if (count > 0 && printed.size() < kMostPrinted) printed.append(buffer.data(), static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && errno == EINTR);
}

bool ChildProcess::write(std::string_view bytes, double seconds) {
  Clock::time_point latest = after(seconds);
  while (!bytes.empty()) {
    const short ready = awaited(impl_->socket, POLLIN | POLLOUT, kTenthOfASecond);
    if (impl_->stop() || Clock::now() > latest) return false;
    if ((ready & POLLIN) != 0 && !impl_->readSome()) return false;
    if ((ready & (POLLOUT | POLLHUP | POLLERR)) == 0) continue;
    const ssize_t sent = send(impl_->socket, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (sent < 0 && errno != EINTR && errno != EAGAIN) return false;
    if (sent > 0) latest = after(seconds);
    bytes.remove_prefix(sent < 0 ? 0 : static_cast<std::size_t>(sent));
  }
  return true;
}

ChildProcess::Ending ChildProcess::wait(double seconds) {
  const Clock::time_point latest = after(seconds);
  shutdown(impl_->socket, SHUT_WR);
  for (bool open = true; impl_->pid != 0;) {
    // It may close its outputs and go on; what it has started may keep them open and go on without it.
    const short ready = open ? awaited(impl_->socket, POLLIN, kTenthOfASecond) : awaited(-1, 0, kHundredthOfASecond);
    if (ready != 0) open = impl_->readSome();
    if (ready == 0 || !open) (void)impl_->hasEnded();
    if (impl_->pid != 0 && (impl_->stop() || Clock::now() > latest)) {
      const bool stopped = impl_->stop();
      impl_->end();
      return {stopped ? Ending::Kind::Stopped : Ending::Kind::TooLate};
    }
  }
  constexpr int kMostReads = 1024;  // of last words; what it has started may print without end
  for (int k = 0; k < kMostReads && awaited(impl_->socket, POLLIN, 0) != 0 && impl_->readSome(); ++k) {
  }
  return {Ending::Kind::ByItself, impl_->status};
}

bool ChildProcess::Impl::hasEnded() {
  int ending = 0;
  const pid_t ended = waitpid(pid, &ending, WNOHANG);
  if (ended == 0 || (ended < 0 && errno == EINTR)) return false;
  forget(ending);
  return true;
}

void ChildProcess::Impl::end() {
  kill(-pid, SIGKILL);
  int ending = 0;
  while (waitpid(pid, &ending, 0) < 0 && errno == EINTR) {
  }
  forget(ending);
}

void ChildProcess::Impl::forget(int ending) {
  running.reset();
  pid = 0;
  status = WIFEXITED(ending) ? WEXITSTATUS(ending) : -1;
}

}  // namespace tyg

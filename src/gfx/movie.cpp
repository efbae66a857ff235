// ffmpeg as a child process that reads frames from a pipe; see movie.h.
#include "gfx/movie.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <string_view>
#include <system_error>
#include <vector>

#include "tyg/input_error.h"
#include "util/file_names.h"
#include "util/whole_file.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves declaring it to the program

namespace tyg {
namespace {

/// ffmpeg that ends early must be an error to report, not a signal that ends this program.
class NoBrokenPipeSignal {
 public:
  NoBrokenPipeSignal() : before_(std::signal(SIGPIPE, SIG_IGN)) {}
  ~NoBrokenPipeSignal() { std::signal(SIGPIPE, before_); }
  NoBrokenPipeSignal(const NoBrokenPipeSignal&) = delete;
  NoBrokenPipeSignal& operator=(const NoBrokenPipeSignal&) = delete;

 private:
  void (*before_)(int);
};

struct Pipe {
  int read = -1, write = -1;
  Pipe() {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category());
    read = ends[0], write = ends[1];
  }
  ~Pipe() { closeEnd(read), closeEnd(write); }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  static void closeEnd(int& end) {
    if (end >= 0) close(end);
    end = -1;
  }
};

std::vector<std::string> commandLine(const std::filesystem::path& out, int width, int height, double fps) {
  std::ostringstream rate;
  rate << fps;
  std::vector<std::string> words{
      "ffmpeg",   "-loglevel", "error", "-y", "-f",
      "rawvideo", "-pix_fmt",  "rgba",  "-s", std::to_string(width) + "x" + std::to_string(height),
      "-r",       rate.str(),  "-i",    "-",  "-an"};
  const std::vector<std::string> mp4{"-c:v", "libx264", "-crf", "18", "-pix_fmt", "yuv420p", "-movflags", "+faststart"};
  // A GIF has 256 colours; these are chosen from all frames, or thin lines turn grey.
  const std::vector<std::string> gif{"-filter_complex",
                                     "split[a][b];[a]palettegen[p];[b][p]paletteuse=dither=bayer:bayer_scale=3"};
  const std::vector<std::string>& format = endingOf(out) == ".gif" ? gif : mp4;
  words.insert(words.end(), format.begin(), format.end());
  words.push_back("file:" + out.string());  // a name that begins with a dash or holds a colon stays a name
  return words;
}

}  // namespace

bool haveFfmpeg() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (access((std::filesystem::path(folder) / "ffmpeg").c_str(), X_OK) == 0) return true;
  }
  return false;
}

struct Movie::Body {
  WholeFile file;
  NoBrokenPipeSignal quiet;
  Pipe frames, complaints;
  pid_t child = 0;

  explicit Body(const std::filesystem::path& path) : file(path) {}
  ~Body() { wait(); }

  void start(std::vector<std::string> words) {
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, frames.read, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, complaints.write, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, complaints.write, STDERR_FILENO);
    // A group of its own: Ctrl-C in a terminal is for this program, which ends the movie as it should be ended.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    const int error = posix_spawnp(&child, "ffmpeg", &actions, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) {
      child = 0;
      throw InputError("cannot start ffmpeg: " + std::generic_category().message(error));
    }
    Pipe::closeEnd(frames.read), Pipe::closeEnd(complaints.write);
  }

  /// Ends the movie and says whether ffmpeg is content with it.
  bool wait() {
    Pipe::closeEnd(frames.write);
    if (child == 0) return false;
    int status = 0;
    pid_t ended = 0;
    do {
      ended = waitpid(child, &status, 0);
    } while (ended < 0 && errno == EINTR);
    child = 0;
    return ended > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }

  [[noreturn]] void complain() {
    wait();
    std::array<char, 2000> text{};
    const ssize_t count = read(complaints.read, text.data(), text.size());
    throw InputError("ffmpeg could not make the movie: " +
                     (count > 0 ? std::string(text.data(), static_cast<std::size_t>(count)) : "it gave no reason"));
  }
};

Movie::Movie(const std::filesystem::path& path, int width, int height, double fps)
    : body_(std::make_unique<Body>(path)) {
  body_->start(commandLine(body_->file.temporary(), width, height, fps));
}

Movie::~Movie() = default;

void Movie::add(const Picture& picture) {
  const std::uint8_t* data = picture.rgba.data();
  std::size_t left = picture.rgba.size();
  while (left > 0) {
    const ssize_t written = write(body_->frames.write, data, left);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) body_->complain();
    data += written;
    left -= static_cast<std::size_t>(written);
  }
}

void Movie::finish() {
  if (!body_->wait()) body_->complain();
  body_->file.keep();
}

}  // namespace tyg

// ffmpeg as a child process that reads the frames from its standard input.
#include "gfx/movie.h"

#include <system_error>
#include <vector>

#include <fmt/core.h>

#include "tyg/input_error.h"
#include "util/child_process.h"
#include "util/file_names.h"
#include "util/utf8.h"
#include "util/whole_file.h"

namespace tyg {
namespace {

std::vector<std::string> commandLine(const std::filesystem::path& out, int width, int height, double fps) {
  std::vector<std::string> words{"ffmpeg",   "-loglevel",
                                 "error",    "-y",
                                 "-f",       "rawvideo",
                                 "-pix_fmt", "rgba",
                                 "-s",       fmt::format("{}x{}", width, height),
                                 "-r",       fmt::format("{:g}", fps),
                                 "-i",       "-",
                                 "-an"};
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

bool haveFfmpeg() { return isOnPath("ffmpeg"); }

/// ffmpeg is killed before its file is removed.
struct Movie::Impl {
  WholeFile file;
  ChildProcess ffmpeg;

  Impl(const std::filesystem::path& path, int width, int height, double fps)
      : file(path), ffmpeg(commandLine(file.temporary(), width, height, fps)) {}

  [[noreturn]] void refuse() const {
    constexpr std::size_t kLongest = 2000;
    const std::string reason(cutToBytes(ffmpeg.printed(), kLongest));
    throw InputError("ffmpeg could not make the movie: " + (reason.empty() ? "it gave no reason" : reason));
  }
};

Movie::Movie(const std::filesystem::path& path, int width, int height, double fps) try
    : impl_(std::make_unique<Impl>(path, width, height, fps)) {
} catch (const std::system_error& error) {
  throw InputError("cannot start ffmpeg: " + error.code().message());
}

Movie::~Movie() = default;

void Movie::add(const Picture& picture) {
  const auto* bytes = reinterpret_cast<const char*>(picture.rgba.data());
  if (impl_->ffmpeg.write({bytes, picture.rgba.size()})) return;
  impl_->ffmpeg.wait();
  impl_->refuse();
}

void Movie::finish() {
  if (impl_->ffmpeg.wait() != 0) impl_->refuse();
  impl_->file.keep();
}

}  // namespace tyg

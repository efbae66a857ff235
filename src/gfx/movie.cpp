// ffmpeg as a child process that reads the frames from its standard input.
#include "gfx/movie.h"

#include <system_error>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "tyg/input_error.h"
#include "util/child_process.h"
#include "util/file_names.h"
#include "util/utf8.h"
#include "util/whole_picture.h"

namespace tyg {
namespace {

std::vector<std::string> commandLine(const std::filesystem::path& out, const MovieForm& form) {
  std::vector<std::string> words{"ffmpeg",   "-loglevel",
                                 "error",    "-y",
                                 "-f",       "rawvideo",
                                 "-pix_fmt", "rgba",
                                 "-s",       fmt::format("{}x{}", form.width, form.height),
                                 "-r",       fmt::format("{:g}", form.fps),
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
  std::function<bool()> stop;
  double patience, longestEnd = 60;  // s
  ChildProcess ffmpeg;

  Impl(const std::filesystem::path& path, const MovieForm& form, std::function<bool()> stopped)
      : file(path),
        stop(std::move(stopped)),
        patience(form.patience),
        ffmpeg(commandLine(file.temporary(), form), {}, stop) {}

  [[noreturn]] void refuse(const ChildProcess::Ending& ending) const {
    constexpr std::size_t kLongest = 2000;
    std::string reason(cutToBytes(ffmpeg.printed(), kLongest));
    if (ending.kind == ChildProcess::Ending::Kind::TooLate) reason += "it did not go on";
    throw InputError("ffmpeg could not make the movie: " + (reason.empty() ? "it gave no reason" : reason));
  }
};

Movie::Movie(const std::filesystem::path& path, const MovieForm& form, std::function<bool()> stop) try
    : impl_(std::make_unique<Impl>(path, form, std::move(stop))) {
} catch (const std::system_error& error) {
  throw InputError("cannot start ffmpeg: " + error.code().message());
}

Movie::~Movie() = default;

void Movie::add(const Picture& picture) {
  constexpr double kLastWords = 1;  // s
  const auto* bytes = reinterpret_cast<const char*>(picture.rgba.data());
  // It may keep all that it gets until the end, and then take as long for it as the slowest machine needs.
  constexpr double kSlowest = 1e-6;  // s a pixel
  impl_->longestEnd += kSlowest * picture.width * picture.height;
  if (impl_->ffmpeg.write({bytes, picture.rgba.size()}, impl_->patience) || impl_->stop()) return;
  impl_->refuse(impl_->ffmpeg.wait(kLastWords));
}

bool Movie::finish() {
  const ChildProcess::Ending ending = impl_->ffmpeg.wait(impl_->longestEnd);
  if (ending.kind == ChildProcess::Ending::Kind::Stopped) return false;
  if (!ending.good()) impl_->refuse(ending);
  keepPictures({&impl_->file});
  return true;
}

}  // namespace tyg

// Numbered names, pictures of even sizes, and one picture of a movie for each thirtieth of a second of the clock.
#include "ui/capture_files.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "util/file_names.h"
#include "util/visible_text.h"
#include "util/whole_file.h"

namespace tyg {
namespace {

/// A pause longer than this is not filmed, s: a window that was hidden leaves no still picture.
constexpr double kLongestGap = 1;
/// The window waits this long for an ffmpeg that takes no picture, s.
constexpr double kPatience = 3;

/// The upper left part of a picture.
void cut(const Picture& from, int width, int height, Picture& to) {
  to.width = width, to.height = height;
  to.rgba.resize(4 * std::size_t(width) * std::size_t(height));
  for (int row = 0; row < height; ++row) {
    const auto begin = from.rgba.begin() + 4 * std::ptrdiff_t(from.width) * row;
    std::copy(begin, begin + 4 * std::ptrdiff_t(width), to.rgba.begin() + 4 * std::ptrdiff_t(width) * row);
  }
}

/// Pictures, scenes, logs and movies share their numbers, so that what belongs together is called the same.
std::string freeStemFor(const std::filesystem::path& folder, const std::string& sceneName) {
  constexpr std::array<std::string_view, 4> kEndings{".png", ".toml", ".csv", ".mp4"};
  return freeStem(folder, "tyg-" + fileStem(sceneName), kEndings, FirstName::Numbered);
}

}  // namespace

CaptureFiles::~CaptureFiles() { givenUp_ = true; }

std::string CaptureFiles::keep(const Picture& picture, const EventLog& log) {
  const std::string stem = freeStemFor(folder_, log.scene);
  writePng(picture, folder_ / (stem + ".png"));
  writeWholeFile(folder_ / (stem + ".toml"), log.sceneText);
  writeWholeFile(folder_ / (stem + ".csv"), formatEventLog(log));
  return stem + ".png is kept; tyg run --replay " + shellWord(stem + ".csv") + " does this run again.";
}

void CaptureFiles::beginMovie(const std::string& sceneName, int width, int height) {
  if (!haveFfmpeg()) throw InputError("movies need ffmpeg, which is not installed");
  if (finishing()) throw InputError("the last movie is still being finished");
  width_ = width / 2 * 2, height_ = height / 2 * 2;
  movieName_ = freeStemFor(folder_, sceneName) + ".mp4";
  frames_ = 0;
  const MovieForm form{.width = width_, .height = height_, .fps = kFramesPerSecond, .patience = kPatience};
  movie_ = std::make_unique<Movie>(folder_ / movieName_, form, [this] { return givenUp_.load(); });
}

std::string CaptureFiles::film(const Picture& picture, double now) {
  if (!movie_) return {};
  if (picture.width / 2 * 2 != width_ || picture.height / 2 * 2 != height_) return endMovie();
  try {
    if (frames_ > 0) {
      began_ = std::max(began_, now - filmed() - kLongestGap);
      const long due = std::lround((now - began_) * kFramesPerSecond);
      for (; frames_ < due; ++frames_) movie_->add(frame_);
    } else {
      began_ = now;
    }
    cut(picture, width_, height_, frame_);
    if (frames_ == 0) movie_->add(frame_), ++frames_;
  } catch (...) {
    movie_.reset();
    throw;
  }
  return {};
}

std::string CaptureFiles::endMovie() {
  if (!movie_) return {};
  std::unique_ptr<Movie> movie = std::move(movie_);
  if (frames_ == 0) return "The movie ended before it began: nothing was written.";
  finished_ = std::async(std::launch::async, [movie = std::move(movie), name = movieName_] {
    return name + (movie->finish() ? " is kept." : " was given up before it was finished: nothing was written.");
  });
  return {};
}

std::string CaptureFiles::finishedMovie() {
  const bool isReady = finishing() && finished_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  return isReady ? finished_.get() : std::string();
}

std::string CaptureFiles::awaitMovie(const std::function<bool()>& hurry) {
  constexpr int kSteps = 50;  // of a tenth of a second, once there is no more time
  for (int steps = 0; finishing() && finished_.wait_for(std::chrono::milliseconds(100)) != std::future_status::ready;) {
    if (hurry() && ++steps >= kSteps) givenUp_ = true;
  }
  return finishing() ? finished_.get() : std::string();
}

}  // namespace tyg

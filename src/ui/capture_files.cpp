// Numbered names, pictures of even sizes, and one picture of a movie for each thirtieth of a second of the clock.
#include "ui/capture_files.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "util/file_names.h"
#include "util/visible_text.h"
#include "util/whole_file.h"

namespace tyg {
namespace {

/// A pause longer than this is not filmed, s: a window that was hidden leaves no still picture.
constexpr double kLongestGap = 1;
/// An ffmpeg that takes no picture for so long is given up, s.
constexpr double kPatience = 20;

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

std::string CaptureFiles::keep(const Picture& picture, const std::string& sceneText, const EventLog& log) {
  const std::string stem = freeStemFor(folder_, log.scene);
  writePng(picture, folder_ / (stem + ".png"));
  writeWholeFile(folder_ / (stem + ".toml"), sceneText);
  writeWholeFile(folder_ / (stem + ".csv"), formatEventLog(log));
  return "saved to " + (folder_ / stem).string() + ".png, .toml and .csv; tyg run --replay " +
         shellWord(stem + ".csv") + " does this run again";
}

void CaptureFiles::beginMovie(const std::string& sceneName, int width, int height) {
  if (!haveFfmpeg()) throw InputError("movies need ffmpeg, which is not installed");
  if (finishing()) throw InputError("the last movie is still being finished");
  width_ = width / 2 * 2, height_ = height / 2 * 2;
  movieName_ = freeStemFor(folder_, sceneName) + ".mp4";
  frames_ = 0;
  const MovieForm form{.width = width_, .height = height_, .fps = kFramesPerSecond, .patience = kPatience};
  movie_ = std::make_unique<MovieFeeder>(folder_ / movieName_, form);
}

std::string CaptureFiles::film(const Picture& picture, double now) {
  if (!filming()) return {};
  if (picture.width / 2 * 2 != width_ || picture.height / 2 * 2 != height_) return endMovie();
  if (frames_ > 0) {
    began_ = std::max(began_, now - filmed() - kLongestGap);
    const long due = std::lround((now - began_) * kFramesPerSecond);
    if (due > frames_) movie_->add(frame_, due - frames_);
    frames_ = std::max(frames_, due);
  } else {
    began_ = now;
  }
  cut(picture, width_, height_, frame_);
  if (frames_ == 0) movie_->add(frame_, 1), ++frames_;
  return {};
}

std::string CaptureFiles::endMovie() {
  if (!filming()) return {};
  if (frames_ > 0) {
    movie_->end();
    return {};
  }
  movie_.reset();
  return "The movie ended before it began: nothing was written.";
}

std::string CaptureFiles::movieDone() {
  if (!movie_ || !movie_->isDone()) return {};
  const std::unique_ptr<MovieFeeder> movie = std::move(movie_);
  if (!movie->result()) return movieName_ + " was given up before it was finished: nothing was written.";
  return "saved to " + (folder_ / movieName_).string();
}

std::string CaptureFiles::awaitMovie(const std::function<bool()>& hurry) {
  constexpr double kOften = 0.1;  // s
  constexpr int kMostWaits = 50;  // once there is no more time
  for (int waits = 0; movie_ && !movie_->isDone(kOften);) {
    if (hurry() && ++waits >= kMostWaits) movie_->giveUp();
  }
  return movieDone();
}

}  // namespace tyg

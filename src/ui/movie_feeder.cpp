// A thread takes the pictures from a short queue and waits for ffmpeg in the window's place.
#include "ui/movie_feeder.h"

#include <chrono>
#include <memory>
#include <utility>

namespace tyg {
namespace {

constexpr std::size_t kMostWaiting = 4;  // pictures

}  // namespace

MovieFeeder::MovieFeeder(const std::filesystem::path& path, const MovieForm& form) {
  auto movie = std::make_unique<Movie>(path, form, [this] { return givenUp_.load(); });
  result_ = std::async(std::launch::async, [this, movie = std::move(movie)] { return feed(*movie); });
}

MovieFeeder::~MovieFeeder() {
  giveUp();
  end();
}

void MovieFeeder::add(const Picture& picture, long frames) {
  const std::lock_guard lock(mutex_);
  if (waiting_.size() < kMostWaiting) {
    waiting_.push_back({picture, frames});
  } else {
    waiting_.back().frames += frames;
  }
  changed_.notify_one();
}

void MovieFeeder::end() {
  const std::lock_guard lock(mutex_);
  ended_ = true;
  changed_.notify_one();
}

bool MovieFeeder::isDone(double seconds) const {
  return result_.wait_for(std::chrono::duration<double>(seconds)) == std::future_status::ready;
}

bool MovieFeeder::feed(Movie& movie) {
  while (true) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return ended_ || !waiting_.empty(); });
    if (waiting_.empty()) break;
    const Shown shown = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    for (long frame = 0; frame < shown.frames && !givenUp_; ++frame) movie.add(shown.picture);
  }
  return movie.finish();
}

}  // namespace tyg

// A movie that is made beside the frame loop: pictures are handed over and never waited for, so that neither a slow
// ffmpeg nor one that hangs stops the window. Must not know: what is filmed, when pictures are due.
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <filesystem>
#include <future>
#include <mutex>

#include "gfx/movie.h"

namespace tyg {

class MovieFeeder {
 public:
  /// Throws InputError as Movie does.
  MovieFeeder(const std::filesystem::path& path, const MovieForm& form);
  ~MovieFeeder();  ///< A movie that is not finished leaves no file
  MovieFeeder(const MovieFeeder&) = delete;
  MovieFeeder& operator=(const MovieFeeder&) = delete;

  /// Shows the picture for so many frames. Where ffmpeg is some pictures behind, the one before is shown instead.
  void add(const Picture& picture, long frames);
  /// That was the last picture: the movie is finished.
  void end();
  [[nodiscard]] bool ended() const { return ended_; }
  /// Ends everything soon, without a file.
  void giveUp() { givenUp_ = true; }

  /// Whether the movie is finished or has failed, waiting for so many seconds at most.
  [[nodiscard]] bool isDone(double seconds = 0) const;
  /// To be asked once, when it is done: whether there is a file. Throws InputError with what ffmpeg said.
  bool result() { return result_.get(); }

 private:
  struct Shown {
    Picture picture;
    long frames;
  };
  bool feed(Movie& movie);

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Shown> waiting_;
  std::atomic<bool> ended_ = false, givenUp_ = false;
  std::future<bool> result_;  // last: its thread uses all of the above
};

}  // namespace tyg

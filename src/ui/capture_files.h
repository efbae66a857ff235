// What the window keeps in files on request: a picture, the run that leads to it, a movie. Nothing is overwritten:
// names are numbered. Must not know: how pictures are drawn, which keys ask for them.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <string>

#include "gfx/movie.h"
#include "tyg/event_log.h"
#include "tyg/scene.h"

namespace tyg {

class CaptureFiles {
 public:
  static constexpr double kFramesPerSecond = 30;

  /// Files go into `folder`, which must exist by then; their names are tyg-SCENE-NUMBER.
  explicit CaptureFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}
  ~CaptureFiles();  ///< A movie that is not finished leaves no file
  CaptureFiles(const CaptureFiles&) = delete;
  CaptureFiles& operator=(const CaptureFiles&) = delete;

  /// Writes the picture, the scene as the run began it, and the run's log, which holds that scene as well. Returns one
  /// sentence that names the files. Throws InputError where they cannot be written.
  std::string keep(const Picture& picture, const EventLog& log);

  /// Begins a movie of pictures `width` x `height` (odd ones lose a row or column of pixels). Throws InputError where
  /// ffmpeg is missing or the file cannot be written.
  void beginMovie(const std::string& sceneName, int width, int height);
  /// What is seen at this time (s, of any clock): it is shown until the next one. A picture of another size ends the
  /// movie. Returns a sentence where the movie has ended, else nothing. Throws InputError with what ffmpeg said.
  std::string film(const Picture& picture, double now);
  /// From here on the movie is finished in the background. Returns a sentence where there is nothing to finish.
  std::string endMovie();
  [[nodiscard]] bool finishing() const { return finished_.valid(); }
  /// A sentence that names the file, once, when the movie is finished; until then nothing. Throws InputError with what
  /// ffmpeg said.
  std::string finishedMovie();
  /// Waits for what finishedMovie() says; once `hurry` says so no longer than five seconds, and then there is no file.
  std::string awaitMovie(const std::function<bool()>& hurry);
  [[nodiscard]] bool filming() const { return movie_ != nullptr; }
  [[nodiscard]] double filmed() const { return double(frames_) / kFramesPerSecond; }  ///< s
  [[nodiscard]] const std::string& movieName() const { return movieName_; }           ///< of the last movie begun

 private:
  std::filesystem::path folder_;
  std::unique_ptr<Movie> movie_;
  std::string movieName_;
  Picture frame_;
  int width_ = 0, height_ = 0;
  double began_ = 0;  ///< s
  long frames_ = 0;
  std::atomic<bool> givenUp_ = false;
  std::future<std::string> finished_;  // last: it is waited for while all else is there
};

}  // namespace tyg

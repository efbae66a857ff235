// What the window keeps in files on request: a picture, the run that leads to it, a movie. Nothing is overwritten:
// names are numbered. Must not know: how pictures are drawn, which keys ask for them.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "tyg/event_log.h"
#include "tyg/scene.h"
#include "ui/movie_feeder.h"

namespace tyg {

class CaptureFiles {
 public:
  static constexpr double kFramesPerSecond = 30;

  /// Files go into `folder`, which must exist by then; their names are tyg-SCENE-NUMBER.
  explicit CaptureFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Writes the picture, the text of the scene that is shown, and the run's log, which holds the scene as the run began
  /// it. Returns one sentence that names the files. Throws InputError where they cannot be written.
  std::string keep(const Picture& picture, const std::string& sceneText, const EventLog& log);

  /// Begins a movie of pictures `width` x `height` (odd ones lose a row or column of pixels). Throws InputError where
  /// ffmpeg is missing or the file cannot be written.
  void beginMovie(const std::string& sceneName, int width, int height);
  /// What is seen at this time (s, of any clock): it is shown until the next one. It is not waited for. A picture of
  /// another size ends the movie. Returns a sentence where there is nothing to finish then.
  std::string film(const Picture& picture, double now);
  /// From here on the movie is finished in the background. Returns a sentence where there is nothing to finish.
  std::string endMovie();
  [[nodiscard]] bool filming() const { return movie_ && !movie_->ended(); }
  [[nodiscard]] bool finishing() const { return movie_ && movie_->ended(); }
  /// A sentence that names the file, once, when the movie is finished; until then nothing. Throws InputError with what
  /// ffmpeg said where it has given up.
  std::string movieDone();
  /// Waits for what movieDone() says; once `hurry` says so no longer than five seconds, and then there is no file.
  std::string awaitMovie(const std::function<bool()>& hurry);
  [[nodiscard]] double filmed() const { return double(frames_) / kFramesPerSecond; }  ///< s
  [[nodiscard]] const std::string& movieName() const { return movieName_; }           ///< of the last movie begun

 private:
  std::filesystem::path folder_;
  std::unique_ptr<MovieFeeder> movie_;
  std::string movieName_;
  Picture frame_;
  int width_ = 0, height_ = 0;
  double began_ = 0;  ///< s
  long frames_ = 0;
};

}  // namespace tyg

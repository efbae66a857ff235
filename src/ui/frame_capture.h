// Pictures and movies of the window: keys ask for them, and they are taken at the point of a frame where what they show
// is drawn. Must not know: how anything is drawn, how files are written.
#pragma once

#include <filesystem>
#include <string>

#include "gfx/picture.h"
#include "ui/capture_files.h"
#include "viewer/viewer.h"

namespace tyg {

class FrameCapture {
 public:
  /// Files go into `folder`.
  explicit FrameCapture(std::filesystem::path folder) : files_(std::move(folder)) {}

  /// True where the event was a key that asks for a picture, or for the beginning or end of a movie.
  bool handle(const WindowEvent& event);
  /// When the cloth is drawn, and no text yet: a frame of the movie. What happened is said in the viewer's notes.
  void film(Viewer& viewer, Extent window);
  /// When everything is drawn: the picture, if it was asked for.
  void takePicture(Viewer& viewer, Extent window);
  /// `filming into NAME · 1.2 s · Z ends it`, then `finishing NAME`; empty while nothing is filmed.
  [[nodiscard]] std::string filmingText() const;
  /// Ends a movie that is still being filmed, and waits until it is finished. Returns a sentence that names the file,
  /// or nothing. Throws InputError.
  std::string end();
  /// Whether a movie is being finished.
  [[nodiscard]] bool busy() const { return files_.finishing(); }

 private:
  void toggleMovie(Viewer& viewer, Extent window);

  CaptureFiles files_;
  Picture pixels_;
  bool pictureAsked_ = false, movieAsked_ = false;
};

}  // namespace tyg

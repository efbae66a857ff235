// Movies through ffmpeg, where it is installed: it reads raw frames and writes one MP4 or GIF, whole or not at all.
// Must not know: what the frames show.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "gfx/picture.h"

namespace tyg {

/// Is there an ffmpeg on the PATH?
bool haveFfmpeg();

struct MovieForm {
  int width = 0, height = 0;  ///< pixels; both even in an MP4
  double fps = 30;            ///< frames per second, > 0
  double patience = 60;       ///< s: ffmpeg is given up where it takes nothing for so long
};

/// One movie being made. Where it is destroyed before finish(), ffmpeg is ended and no file is left.
class Movie {
 public:
  /// `path` ends in .mp4 (H.264) or .gif. `stop` is asked many times a second whether the movie is to be given up.
  /// Throws InputError where the file cannot be written or ffmpeg cannot be started.
  Movie(
      const std::filesystem::path& path, const MovieForm& form, std::function<bool()> stop = [] { return false; });
  ~Movie();
  Movie(const Movie&) = delete;
  Movie& operator=(const Movie&) = delete;

  /// The next frame; its size is the movie's. Throws InputError with what ffmpeg said where it has given up.
  void add(const Picture& picture);
  /// Waits for ffmpeg and puts the file in its place once it is whole. Returns false where `stop` said so, and there is
  /// no file. Throws InputError with what ffmpeg said.
  bool finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tyg

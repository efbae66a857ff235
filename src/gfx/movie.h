// Movies through ffmpeg, where it is installed: it reads raw frames and writes one MP4 or GIF, whole or not at all.
// Must not know: what the frames show.
#pragma once

#include <filesystem>
#include <memory>

#include "gfx/picture.h"

namespace tyg {

/// Is there an ffmpeg on the PATH?
bool haveFfmpeg();

/// One movie being made. Where it is destroyed before finish(), ffmpeg is ended and no file is left.
class Movie {
 public:
  /// `path` ends in .mp4 (H.264; both sizes must be even) or .gif; `fps` frames per second, > 0. Throws InputError
  /// where the file cannot be written or ffmpeg cannot be started.
  Movie(const std::filesystem::path& path, int width, int height, double fps);
  ~Movie();
  Movie(const Movie&) = delete;
  Movie& operator=(const Movie&) = delete;

  /// The next frame; its size is the movie's. Throws InputError with what ffmpeg said where it has given up.
  void add(const Picture& picture);
  /// Waits for ffmpeg and puts the file in its place. Throws InputError with what ffmpeg said.
  void finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tyg

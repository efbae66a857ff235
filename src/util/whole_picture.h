// Whether another program has written a picture or a movie to its end, which its exit status does not always tell:
// gnuplot and ffmpeg may end with 0 on a full disk. Must not know: which program it was, what is shown.
#pragma once

#include <filesystem>

#include "util/whole_file.h"

namespace tyg {

/// Reads the parts that the file consists of, not the pixels: an SVG has its last tag, a PNG, GIF or MP4 all its parts
/// up to the last one and nothing behind it. False for other endings than .svg, .png, .gif and .mp4.
bool isWholePicture(const std::filesystem::path& path);

/// Puts the pictures that another program has written to temporary() in their places, once all of them are whole.
/// Throws InputError where one is not; then none is replaced.
void keepPictures(std::initializer_list<WholeFile*> files);

}  // namespace tyg

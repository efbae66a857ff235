// A picture in memory, to PNG, and from PNG and JPEG.
// Must not know: OpenGL, what it shows.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tyg {

/// Red, green, blue, alpha, 0..255 each, top row first.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  ///< 4 * width * height numbers
};

/// The bytes of a PNG file. Throws std::invalid_argument for a picture without pixels.
std::string encodePng(const Picture& picture);
/// Writes a PNG file whole or not at all. Throws InputError where it cannot be written.
void writePng(const Picture& picture, const std::filesystem::path& path);
/// From a PNG or JPEG file. Throws InputError where there is none that can be read, or where it is larger than
/// kLargestPicture pixels a side.
inline constexpr int kLargestPicture = 8192;
Picture readPicture(const std::filesystem::path& path);

}  // namespace tyg

// PNG and JPEG by the stb library, whose code is compiled here and only here.
#include "gfx/picture.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "tyg/input_error.h"
#include "util/whole_file.h"

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb_image.h>
#include <stb_image_write.h>
#pragma GCC diagnostic pop

namespace tyg {

std::string encodePng(const Picture& picture) {
  const std::size_t wanted = 4 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  if (picture.width <= 0 || picture.height <= 0 || picture.rgba.size() != wanted) {
    throw std::invalid_argument("a picture without pixels cannot become a PNG");
  }
  std::string bytes;
  const auto append = [](void* to, void* data, int size) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
  };
  stbi_write_png_to_func(append, &bytes, picture.width, picture.height, 4, picture.rgba.data(), 4 * picture.width);
  return bytes;
}

void writePng(const Picture& picture, const std::filesystem::path& path) { writeWholeFile(path, encodePng(picture)); }

Picture readPicture(const std::filesystem::path& path) {
  const std::string allowed = fmt::format("a PNG or JPEG picture of up to {0} x {0} pixels", kLargestPicture);
  const std::string bytes = readWholeFile(path, "cannot read the picture", allowed);
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(std::min<std::size_t>(bytes.size(), std::numeric_limits<int>::max()));
  Picture picture;
  int channels = 0;
  const bool known = stbi_info_from_memory(data, size, &picture.width, &picture.height, &channels) != 0;
  if (known && std::max(picture.width, picture.height) > kLargestPicture) {
    throw InputError(
        fmt::format("{}: found {} x {} pixels, allowed {}", path.string(), picture.width, picture.height, allowed));
  }
  stbi_uc* pixels = known ? stbi_load_from_memory(data, size, &picture.width, &picture.height, &channels, 4) : nullptr;
  if (pixels == nullptr) {
    throw InputError(
        fmt::format("{}: found what is no picture ({}), allowed {}", path.string(), stbi_failure_reason(), allowed));
  }
  picture.rgba.assign(pixels,
                      pixels + 4 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
  stbi_image_free(pixels);
  return picture;
}

}  // namespace tyg

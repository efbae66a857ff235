// PNG by the stb library, whose code is compiled here and only here.
#include "gfx/picture.h"

#include <stdexcept>

#include "tyg/input_error.h"
#include "util/whole_file.h"

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
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

Picture readPng(const std::filesystem::path& path) {
  Picture picture;
  int channels = 0;
  stbi_uc* pixels = stbi_load(path.c_str(), &picture.width, &picture.height, &channels, 4);
  if (pixels == nullptr) {
    throw InputError(path.string() + ": expected a PNG picture: " + stbi_failure_reason());
  }
  picture.rgba.assign(pixels,
                      pixels + 4 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
  stbi_image_free(pixels);
  return picture;
}

}  // namespace tyg

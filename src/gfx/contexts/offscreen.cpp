// Tries the kinds of context in the order of preference, and turns what was drawn into a picture, top row first.
#include "gfx/contexts/offscreen.h"

#include <fmt/core.h>
#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "gfx/contexts/offscreen_kinds.h"

namespace tyg {
namespace {
#ifdef _WIN32
constexpr std::array kKinds{OffscreenKind::Wgl};
#elif defined(TYG_HAVE_OSMESA)
constexpr std::array kKinds{OffscreenKind::OsMesa, OffscreenKind::Egl};
#else
constexpr std::array kKinds{OffscreenKind::Egl};
#endif
constexpr int kLargest = 16384;  // what today's Mesa can draw into
}  // namespace

std::string_view nameOf(OffscreenKind kind) {
  return kind == OffscreenKind::OsMesa ? "OSMesa" : kind == OffscreenKind::Egl ? "EGL" : "WGL";
}

std::span<const OffscreenKind> offscreenKinds() { return kKinds; }

void loadOpenGl(void (*(*find)(const char* name))()) {
  if (gladLoadGL(find) < GLAD_MAKE_VERSION(3, 3)) {
    throw std::runtime_error("it offers less than OpenGL 3.3");
  }
}

Picture Offscreen::readPixels() const {
  Picture picture;
  readPixels(picture);
  return picture;
}

void Offscreen::readPixels(Picture& picture) const { readFramebuffer(width_, height_, picture); }

void readFramebuffer(int width, int height, Picture& picture) {
  picture.width = width, picture.height = height;
  const std::size_t row = 4 * static_cast<std::size_t>(width);
  picture.rgba.resize(row * static_cast<std::size_t>(height));
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
  // OpenGL's first row is the lowest.
  const auto begin = picture.rgba.begin();
  const auto step = static_cast<std::ptrdiff_t>(row);
  for (std::ptrdiff_t above = 0, below = height - 1; above < below; ++above, --below) {
    std::swap_ranges(begin + above * step, begin + (above + 1) * step, begin + below * step);
  }
}

std::unique_ptr<Offscreen> makeOffscreen(OffscreenKind kind, int width, int height) {
  if (width < 1 || height < 1 || width > kLargest || height > kLargest) {
    throw std::runtime_error(
        fmt::format("a picture can be 1 to {} pixels wide and high; asked for {}x{}", kLargest, width, height));
  }
#ifdef TYG_HAVE_OSMESA
  if (kind == OffscreenKind::OsMesa) {
    return makeOsMesaOffscreen(width, height);
  }
#endif
#ifdef _WIN32
  if (kind == OffscreenKind::Wgl) {
    return makeWglOffscreen(width, height);
  }
#else
  if (kind == OffscreenKind::Egl) {
    return makeEglOffscreen(width, height);
  }
#endif
  throw std::runtime_error(fmt::format("this program was built without {}", nameOf(kind)));
}

std::unique_ptr<Offscreen> makeOffscreen(int width, int height) {
  std::string failures;
  for (const OffscreenKind kind : kKinds) {
    try {
      return makeOffscreen(kind, width, height);
    } catch (const std::runtime_error& error) {
      failures += fmt::format("\n  {}: {}", nameOf(kind), error.what());
    }
  }
  throw std::runtime_error("cannot draw off-screen on this machine:" + failures);
}

}  // namespace tyg

// An OpenGL core context without a window or a display, 4.3 where there is one, else 3.3: OSMesa where the program was
// built with it, or EGL surfaceless; on Windows WGL with a window that is never shown. Must not know: what is drawn.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "gfx/picture.h"

namespace tyg {

enum class OffscreenKind { OsMesa, Egl, Wgl };
/// `OSMesa`, `EGL`, `WGL`.
std::string_view nameOf(OffscreenKind kind);
/// The kinds that this program was built with, the preferred one first.
std::span<const OffscreenKind> offscreenKinds();

/// What the current framebuffer shows, opaque or not as it is, into a picture that is used again, without allocating
/// once it has the size.
void readFramebuffer(int width, int height, Picture& picture);

/// A context and its framebuffer. While it lives it is current, its framebuffer is bound and the OpenGL functions are
/// loaded for it. One at a time: two alive at once is not supported (the loader's function pointers are global).
class Offscreen {
 public:
  virtual ~Offscreen() = default;
  Offscreen(const Offscreen&) = delete;
  Offscreen& operator=(const Offscreen&) = delete;

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] virtual OffscreenKind kind() const = 0;
  using Find = void (*(*)(const char* name))();
  /// Finds its functions, for whoever computes there too.
  [[nodiscard]] virtual Find find() const = 0;
  /// What has been drawn so far, opaque.
  [[nodiscard]] Picture readPixels() const;
  /// The same into a picture that is used again, without allocating once it has the size.
  void readPixels(Picture& picture) const;

 protected:
  Offscreen(int width, int height) : width_(width), height_(height) {}

 private:
  int width_, height_;
};

/// Makes one of that kind, in pixels (1..16384 each). Throws std::runtime_error that says what failed.
std::unique_ptr<Offscreen> makeOffscreen(OffscreenKind kind, int width, int height);
/// The first kind that works. Throws std::runtime_error that names each kind and why it failed.
std::unique_ptr<Offscreen> makeOffscreen(int width, int height);
/// Of the first graphics card that draws; where none does, the same as makeOffscreen().
std::unique_ptr<Offscreen> makeOffscreenOnCard(int width, int height);

}  // namespace tyg

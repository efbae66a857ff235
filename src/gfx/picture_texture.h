// A texture that can be drawn into like a framebuffer: smoothed pictures, small ones for the window's panels too.
// Must not know: what it shows.
#pragma once

#include <functional>
#include <memory>

namespace tyg {

/// Belongs to the context that is current when it is made.
class PictureTexture {
 public:
  /// False where no OpenGL is loaded: then none can be made.
  static bool possible();
  /// In pixels, 1..4096 each. Throws std::runtime_error where the driver cannot draw into such a texture.
  PictureTexture(int width, int height);
  ~PictureTexture();
  PictureTexture(const PictureTexture&) = delete;
  PictureTexture& operator=(const PictureTexture&) = delete;

  /// Draws into it, smoothed as in the window; the framebuffer bound before is bound again afterwards.
  void draw(const std::function<void()>& drawing);
  /// Calls this while what was drawn last is the framebuffer that is bound.
  void read(const std::function<void()>& reading) const;
  [[nodiscard]] unsigned name() const;  ///< of the OpenGL texture; its first row is the lowest
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

 private:
  struct Impl;
  int width_, height_;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tyg

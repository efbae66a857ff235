// A picture as large as the framebuffer that is drawn once and copied many times.
// Must not know: what it shows.
#pragma once

#include <glm/glm.hpp>

#include "gfx/gl_objects.h"

namespace tyg {

class KeptPicture {
 public:
  /// True where a picture can be copied into the bound framebuffer: it has one sample a pixel.
  static bool possible();

  /// Keeps what `painting` draws into an empty framebuffer of so many pixels without depths. The framebuffer that was
  /// bound is bound again. Returns false where the driver can draw into none of this kind.
  template <class Painting>
  bool keep(glm::ivec2 pixels, const Painting& painting) {
    const FramebufferGuard guard;
    if (!begin(pixels)) return false;
    painting();
    return true;
  }
  /// The kept picture into the bound framebuffer, all of it.
  void copy() const;

 private:
  bool begin(glm::ivec2 pixels);

  GlFramebuffer framebuffer_;
  GlRenderbuffer colours_;
  glm::ivec2 pixels_{0};
};

}  // namespace tyg

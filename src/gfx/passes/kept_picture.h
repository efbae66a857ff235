// What a framebuffer shows, kept to be shown again.
// Must not know: what it shows.
#pragma once

#include <glm/glm.hpp>

#include "gfx/gl_objects.h"

namespace tyg {

class KeptPicture {
 public:
  /// True where the bound framebuffer can be kept: it has one sample a pixel.
  static bool possible();

  /// Keeps the colours of the bound framebuffer, of so many pixels from its lower left corner. Returns false where the
  /// driver can keep none.
  bool keep(glm::ivec2 pixels);
  /// The kept colours into the bound framebuffer again.
  void show() const;

 private:
  GlFramebuffer framebuffer_;
  GlRenderbuffer colours_;
  glm::ivec2 pixels_{0};
};

}  // namespace tyg

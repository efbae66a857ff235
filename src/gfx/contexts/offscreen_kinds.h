// The makers of the off-screen contexts, one file each because their headers do not go together.
#pragma once

#include <memory>
#include <stdexcept>

#include "gfx/contexts/compute_context.h"
#include "gfx/contexts/offscreen.h"

namespace tyg {

/// Each throws std::runtime_error that says which step failed; WGL is on Windows, the others elsewhere.
std::unique_ptr<Offscreen> makeEglOffscreen(int width, int height);
std::unique_ptr<Offscreen> makeWglOffscreen(int width, int height);
#ifdef TYG_HAVE_OSMESA
std::unique_ptr<Offscreen> makeOsMesaOffscreen(int width, int height);
std::unique_ptr<ComputeContext> makeOsMesaComputeContext();
#endif

/// The version of OpenGL that programs need which compute.
constexpr int kComputeMajor = 4, kComputeMinor = 3;

/// A context of that version, else of 3.3, which is enough to draw: `make` takes the version. Some drivers give no
/// later one than they are asked for.
template <class Make>
auto makeComputingElseDrawing(const Make& make) {
  try {
    return make(kComputeMajor, kComputeMinor);
  } catch (const std::runtime_error&) {
    return make(3, 3);
  }
}

/// Loads the OpenGL functions through `find`. Throws where they are not those of OpenGL 3.3 core.
void loadOpenGl(void (*(*find)(const char* name))());

}  // namespace tyg

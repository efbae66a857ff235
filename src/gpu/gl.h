// The functions of OpenGL 4.3 as one object, because the compute context has functions of its own beside those of a
// window. Only this room includes it. Must not know: what is computed.
#pragma once

#include <glad/gl.h>

namespace tyg {

/// Valid in the thread of the context alone.
using Gl = GladGLContext;

}  // namespace tyg

// An OpenGL 4.3 core context for programs that compute, with nothing to draw into: a graphics card's, or else the one
// of a driver that lets the processor do a card's work. Must not know: what is computed.
#pragma once

#include <memory>

namespace tyg {

/// Current in the thread that made it while it lives; to be destroyed there. Any number may live beside each other and
/// beside what draws, in threads of their own.
class ComputeContext {
 public:
  using Find = void (*(*)(const char* name))();

  virtual ~ComputeContext() = default;
  /// Finds its functions.
  [[nodiscard]] virtual Find find() const = 0;
};

/// Of the first card that has one, else of EGL without a card, else of OSMesa; on Windows of WGL. Throws
/// std::runtime_error that says why none of them has.
std::unique_ptr<ComputeContext> makeComputeContext();

}  // namespace tyg

// How this room gets an OpenGL context: from whoever knows the system. Must not know: how one is made.
#pragma once

#include <functional>
#include <memory>

namespace tyg {

/// Finds the functions of a context by their names.
using GlFinder = void (*(*)(const char* name))();

/// An OpenGL context that is current in the thread that opened it, until `owner` is released there.
struct OpenedContext {
  std::shared_ptr<void> owner;
  GlFinder find = nullptr;
};

/// Opens one, in the thread that calls. Throws std::runtime_error that says why there is none.
using ContextOpener = std::function<OpenedContext()>;

}  // namespace tyg

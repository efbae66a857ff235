// On Windows there is always a display, and what it refuses freeglut itself tells.
#ifdef _WIN32

#include <windows.h>

#include "gfx/contexts/wgl_context.h"
#include "ui/windows/glut_system.h"

namespace tyg {

struct GlutSystem::Impl {};

GlutSystem::GlutSystem(EndHere /*endHere*/) {}

GlutSystem::~GlutSystem() = default;

void GlutSystem::opened() {}

std::uintptr_t GlutSystem::focus() const { return reinterpret_cast<std::uintptr_t>(GetForegroundWindow()); }

/// glutGetProcAddress() finds extensions alone.
void (*GlutSystem::find(const char* name))() { return WglContext::find(name); }

void GlutSystem::wait(std::chrono::milliseconds longest) {
  MsgWaitForMultipleObjects(0, nullptr, FALSE, DWORD(longest.count()), QS_ALLINPUT);
}

}  // namespace tyg

#endif

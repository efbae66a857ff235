// Cards come first: what serves without one computes on the processor, and is slower than Tyg's own loops there.
#include "gfx/contexts/compute_context.h"

#include <fmt/core.h>

#include <stdexcept>
#include <string>

#include "gfx/contexts/offscreen_kinds.h"

#ifdef _WIN32
#include "gfx/contexts/wgl_context.h"
#else
#include "gfx/contexts/egl_context.h"
#endif

namespace tyg {

#ifdef _WIN32

namespace {

class WglComputeContext final : public ComputeContext {
 public:
  [[nodiscard]] Find find() const override { return WglContext::find; }

 private:
  WglContext context_{kComputeMajor, kComputeMinor};
};

}  // namespace

std::unique_ptr<ComputeContext> makeComputeContext() {
  try {
    return std::make_unique<WglComputeContext>();
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("no driver here offers OpenGL 4.3 ({})", error.what()));
  }
}

#else

namespace {

class EglComputeContext final : public ComputeContext {
 public:
  explicit EglComputeContext(std::shared_ptr<EglDisplay> display)
      : context_(std::move(display), kComputeMajor, kComputeMinor) {}
  [[nodiscard]] Find find() const override { return eglGetProcAddress; }

 private:
  EglContext context_;
};

}  // namespace

std::unique_ptr<ComputeContext> makeComputeContext() {
  std::string failures;
  const auto tried = [&](const char* what, const auto& make) -> std::unique_ptr<ComputeContext> {
    try {
      return make();
    } catch (const std::runtime_error& error) {
      failures += fmt::format("{}{}: {}", failures.empty() ? "" : "; ", what, error.what());
      return nullptr;
    }
  };
  const auto egl = [](const std::shared_ptr<EglDisplay>& display) {
    return std::make_unique<EglComputeContext>(display);
  };
  for (const std::shared_ptr<EglDisplay>& card : EglDisplay::ofCards()) {
    if (auto context = tried("a card", [&] { return egl(card); })) return context;
  }
  if (auto context = tried("EGL", [&] { return egl(EglDisplay::surfaceless()); })) return context;
#ifdef TYG_HAVE_OSMESA
  if (auto context = tried("OSMesa", makeOsMesaComputeContext)) return context;
#endif
  throw std::runtime_error("no driver here offers OpenGL 4.3 (" + failures + ")");
}

#endif

}  // namespace tyg

// Looks a method up in the table of schemes.
#include "gpu/gpu_device.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "gpu/card.h"
#include "gpu/card_integrator.h"
#include "gpu/scheme.h"
#include "tyg/input_error.h"
#include "util/text.h"

namespace tyg {

GpuDevice::GpuDevice(const ContextOpener& open) : card_(std::make_shared<Card>(open)) {}
GpuDevice::GpuDevice(GlFinder find) : card_(std::make_shared<Card>(find)) {}
GpuDevice::~GpuDevice() = default;

const std::string& GpuDevice::name() const { return card_->name(); }

std::size_t GpuDevice::bytesRead() const { return card_->bytesRead(); }

bool GpuDevice::isProcessor() const {
  constexpr std::array<std::string_view, 6> kDrivers{"llvmpipe",    "softpipe",    "swrast",
                                                     "SwiftShader", "GDI Generic", "Microsoft Basic Render"};
  return std::ranges::any_of(kDrivers,
                             [&](std::string_view driver) { return name().find(driver) != std::string::npos; });
}

std::unique_ptr<Integrator<float>> GpuDevice::make(const Method& method, const Scene& scene, const Sheet& sheet) {
  const auto scheme = std::ranges::find(schemes(), method.name, &Scheme::method);
  if (scheme == schemes().end()) {
    throw InputError("integrator: found \"" + std::string(method.name) +
                     "\", allowed on the graphics card: " + joined(gpuMethods()));
  }
  return makeCardIntegrator(card_, *scheme, scene, sheet);
}

std::vector<std::string_view> gpuMethods() {
  std::vector<std::string_view> names;
  for (const Scheme& scheme : schemes()) names.push_back(scheme.method);
  return names;
}

}  // namespace tyg

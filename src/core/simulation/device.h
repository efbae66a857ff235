// What may move a cloth in place of the processor, such as a graphics card: it makes integrators of its own for the
// methods that it knows. Must not know: how it computes, who chose it.
#pragma once

#include <memory>

#include "core/simulation/integrator.h"
#include "tyg/method.h"

namespace tyg {

class Device {
 public:
  virtual ~Device() = default;
  /// An integrator that takes the steps of this method. It keeps what it needs of the device alive. Throws InputError
  /// that gives the reason where the device does not know the method or something of the scene.
  [[nodiscard]] virtual std::unique_ptr<Integrator<float>> make(const Method& method, const Scene& scene,
                                                                const Sheet& sheet) = 0;
};

}  // namespace tyg

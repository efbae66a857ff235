// Positions that stay where a device has them, for whoever draws from there.
// Must not know: what the device is, how anything is drawn.
#pragma once

#include <array>
#include <span>

namespace tyg {

/// Of all particles, as they were when it was made.
class DevicePositions {
 public:
  virtual ~DevicePositions() = default;
  /// By which name the OpenGL context that draws knows the buffer: x, y, z of each particle in index order, m.
  [[nodiscard]] virtual unsigned buffer() const = 0;
  /// The least and the largest x, y and z, m. Where a number of the particles is not finite, so is one of these.
  [[nodiscard]] virtual const std::array<float, 3>& low() const = 0;
  [[nodiscard]] virtual const std::array<float, 3>& high() const = 0;
  /// Copies them; `xyz` holds 3 numbers for each particle.
  virtual void read(std::span<float> xyz) const = 0;
};

}  // namespace tyg

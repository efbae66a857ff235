// Whether a device computes what the processor computes, found out by letting both run the same scene.
// Must not know: what the device is.
#pragma once

#include <memory>

#include "core/simulation/device.h"
#include "tyg/scene.h"

namespace tyg {

struct BitsCompared {
  int steps = 0;      ///< so many were compared
  bool same = true;   ///< the state, and the energies and powers that are found in it
  double strays = 0;  ///< m: how far the particle that is farthest off is from where the processor has it; 0 if same,
                      ///< and where only energies are not
};

constexpr int kStepsCompared = 64;

/// Runs the first 64 steps of the scene on both, or as few as leave it with numbers. Throws InputError where the device
/// does not take the scene.
BitsCompared compareBits(const Scene& scene, const Method& method, const std::shared_ptr<Device>& device, int threads);

}  // namespace tyg

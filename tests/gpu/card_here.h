// The graphics card of the machine that runs the tests, or the driver that stands in for one. Where there is none,
// tests say why and are skipped.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <string>

#include "gfx/contexts/compute_context.h"
#include "gpu/gpu_device.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg {

inline OpenedContext openContextHere() {
  std::shared_ptr<ComputeContext> context = makeComputeContext();
  return {context, context->find()};
}

class OnCard : public testing::Test {
 protected:
  void SetUp() override {
    try {
      device_ = std::make_shared<GpuDevice>(openContextHere);
    } catch (const std::runtime_error& error) {
      GTEST_SKIP() << "no OpenGL 4.3 here: " << error.what();
    }
  }

  [[nodiscard]] Settings onCard() const { return {.threads = 1, .device = device_}; }

  std::shared_ptr<GpuDevice> device_;
};

inline Scene inFloat(Scene scene) {
  scene.precision = Precision::Float;
  return scene;
}

inline Settings onProcessor() { return {.threads = 1}; }

}  // namespace tyg

// The texts of kernels/, which the build embeds.
#pragma once

#include <span>
#include <string_view>

namespace tyg {

struct EmbeddedKernel {
  std::string_view name;  ///< file name, "step.glsl"
  std::string_view text;  ///< GLSL 4.30, without its version
};
std::span<const EmbeddedKernel> embeddedKernels();

}  // namespace tyg

// The shader texts that the build embeds.
#pragma once

#include <span>
#include <string_view>

namespace tyg {
struct EmbeddedShader {
  std::string_view name;  ///< file name, "lines.vert"
  std::string_view text;  ///< GLSL 3.30 core
};
std::span<const EmbeddedShader> embeddedShaders();
}  // namespace tyg

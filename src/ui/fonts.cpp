// Looks for DejaVu Sans where Linux systems keep it.
#include "ui/fonts.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace tyg {
namespace {

/// ImGui's own font, used where DejaVu Sans is missing, is drawn for this size.
constexpr float kBuiltinPixels = 13;
constexpr std::array<const char*, 3> kFontFiles{"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                                                "/usr/share/fonts/TTF/DejaVuSans.ttf",
                                                "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf"};

}  // namespace

ImFont* addFont(ImFontAtlas& atlas, float pixels, bool exact) {
  ImFontConfig config;
  if (exact) {
    config.OversampleH = config.OversampleV = 1;
    config.PixelSnapH = true;
  }
  std::error_code ignored;
  for (const char* file : kFontFiles) {
    if (!std::filesystem::exists(file, ignored)) continue;
    if (ImFont* font = atlas.AddFontFromFileTTF(file, std::round(pixels), &config)) return font;
  }
  config.SizePixels = std::max(kBuiltinPixels, std::round(pixels / kBuiltinPixels) * kBuiltinPixels);
  return atlas.AddFontDefault(&config);
}

}  // namespace tyg

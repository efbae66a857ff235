// The program's font.
// Must not know: windows, what is written with it.
#pragma once

struct ImFont;
struct ImFontAtlas;

namespace tyg {

/// The fonts of a window's text. They belong to ImGui's atlas.
struct TextFonts {
  ImFont* text = nullptr;
  ImFont* large = nullptr;  ///< for what is said in the middle of the window
  float size = 18;          ///< of the text, in ImGui's units
};
/// How many times as large as the text the large font is.
constexpr float kLargeRatio = 1.5F;

/// DejaVu Sans at a size in pixels, or ImGui's own font near that size where DejaVu is not installed. `exact`: the
/// atlas holds each letter pixel by pixel, for copying, not finer, for a GPU that places letters between pixels.
ImFont* addFont(ImFontAtlas& atlas, float pixels, bool exact = false);

}  // namespace tyg

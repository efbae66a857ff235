// The program's font.
// Must not know: windows, what is written with it.
#pragma once

struct ImFont;
struct ImFontAtlas;

namespace tyg {

/// DejaVu Sans at a size in pixels, or ImGui's own font near that size where DejaVu is not installed. `exact`: the
/// atlas holds each letter pixel by pixel, for copying, not finer, for a GPU that places letters between pixels.
ImFont* addFont(ImFontAtlas& atlas, float pixels, bool exact = false);

}  // namespace tyg

// How everything over the picture looks: one place for colours and spacing, so that panels agree with each other and
// with the key help. Must not know: what is shown with it, windows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "view/draw_options.h"

namespace tyg {

/// A colour as ImGui packs it (IM_COL32).
using Colour = std::uint32_t;

/// Colours that read well on one background.
struct Colours {
  Colour text, dim;  ///< what matters; what explains it
  Colour accent;     ///< what is chosen or can be used
  Colour good, warning;
  Colour past;   ///< beyond a limit: vermilion, which the colour-blind tell from `good`
  Colour shade;  ///< behind text that lies over the cloth
  Colour panel;  ///< behind a panel, nearly opaque
  Colour field;  ///< behind an input or a plot
};
const Colours& coloursOn(Background background);

/// colourOfSeries(), the k-th of several curves, families or methods.
Colour seriesColour(std::size_t k, Background background);
/// The same colour, with this share (0..1) of its opacity.
Colour faded(Colour colour, float share);

/// A unit as people write it: `m/s²` for `m/s2`, nothing for `1`.
std::string unitText(std::string_view unit);

/// Gives ImGui's widgets these colours, with spacing for text of `size` pixels.
void applyStyle(Background background, float size);

}  // namespace tyg

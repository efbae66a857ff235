// A scale of colours with numbers below it, for panels that colour the cloth.
// Must not know: what the colours are for.
#pragma once

#include "ui/panels/panel.h"
#include "view/colour_ramp.h"

namespace tyg {

/// Draws the ramp over the panel's width with `low`, the middle and `high` below it, the ends with `unit` (and what
/// else they mean).
void colourBar(const PanelScope& scope, Ramp ramp, double low, double high, const char* unit);

/// A round number (1, 2 or 5 times a power of ten) at or above `value`, that stays as it was while it fits: until
/// something passes it, or it is less than a fifth of it.
double steadyTop(double before, double value);

}  // namespace tyg

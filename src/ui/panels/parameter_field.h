// Fields in which a person sets numbers of a scene, in the control panel. Must not know: what the numbers are for.
#pragma once

#include <array>
#include <string_view>

#include "core/forces/term.h"

namespace tyg {

/// A logarithmic slider in the field's own unit: `scale` of them are one of the value's. True where it was moved.
bool logSlider(const char* id, double& value, double scale, std::array<double, 2> range, const char* format);
/// Such a slider from 0, or for a vector three fields in a row. `unit` is shown in it.
void parameterField(const Parameter& parameter, std::string_view unit, Scene& wanted);

}  // namespace tyg

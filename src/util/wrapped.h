// Breaking text into lines at its spaces alone: ImGui also breaks after full stops, in the middle of numbers.
// Must not know: fonts, where the text is drawn.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace tyg {

/// The text with line breaks instead of spaces where it would become wider than `width`, as `widthOf` measures it.
/// Words are not broken: one that is wider than that gets a line of its own. Line breaks of the text stay.
std::string wrapped(std::string_view text, float width, const std::function<float(std::string_view)>& widthOf);

/// A paragraph of a terminal's page, with its last line break: lines of at most `width` characters, of which all but
/// the first come after `indent`.
std::string paragraph(std::string_view text, std::string_view indent = {}, int width = 94);

}  // namespace tyg

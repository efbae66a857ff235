// Draws charts with gnuplot, where it is installed.
// Must not know: what is drawn.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/charts/method_style.h"

namespace tyg {

struct GnuplotOutcome {
  enum class Kind { Drawn, Missing, Failed };
  Kind kind = Kind::Drawn;
  std::string message;  ///< what gnuplot said, or why it could not be started
};

/// Runs `gnuplot -d -e DEFINITIONS SCRIPT` in `folder` and waits for its end, or ends it at Ctrl-C and
/// after five minutes. `script` is a file in
/// that folder, `definitions` are gnuplot assignments such as png='a.png'.
GnuplotOutcome runGnuplot(const std::filesystem::path& folder, const std::string& script,
                          const std::vector<std::string>& definitions);

/// Any bytes as a gnuplot string literal of those bytes: double quotes, with all that gnuplot could read otherwise
/// (line breaks, quotes, backquotes, signs of comments and macros) as octal numbers.
std::string gnuplotQuoted(const std::string& text);

/// colourOfSeries() on white, as gnuplot writes colours.
std::string chartColour(std::size_t k);
/// gnuplot's type of a hollow point with this mark; the next number is the filled one.
int gnuplotType(Mark mark);

}  // namespace tyg

// gnuplot as a child process, which Ctrl-C ends.
#include "study/charts/gnuplot.h"

#include <array>
#include <system_error>

#include "util/child_process.h"
#include "util/interrupt.h"

namespace tyg {

GnuplotOutcome runGnuplot(const std::filesystem::path& folder, const std::string& script,
                          const std::vector<std::string>& definitions) {
  using Kind = GnuplotOutcome::Kind;
  std::string statements;
  for (const std::string& definition : definitions) statements += definition + ";";
  try {
    ChildProcess gnuplot({"gnuplot", "-e", statements, script}, folder);
    const bool drawn = gnuplot.wait(interrupted) == 0;
    return {drawn ? Kind::Drawn : Kind::Failed, gnuplot.printed()};
  } catch (const std::system_error& error) {
    const bool missing = error.code() == std::errc::no_such_file_or_directory;
    return {missing ? Kind::Missing : Kind::Failed, error.code().message()};
  }
}

std::string gnuplotQuoted(const std::string& text) {
  std::string quoted = "'";
  for (const char character : text) quoted += character == '\'' ? "''" : std::string(1, character);
  return quoted + "'";
}

std::string chartColour(std::size_t k) {
  constexpr std::array<const char*, 7> kColours{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                "#E69F00", "#56B4E9", "#000000"};
  return kColours.at(k % kColours.size());
}

}  // namespace tyg

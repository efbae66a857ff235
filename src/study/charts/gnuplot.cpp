// gnuplot as a child process, which Ctrl-C ends.
#include "study/charts/gnuplot.h"

#include <fmt/core.h>

#include <array>
#include <string_view>
#include <system_error>

#include "util/child_process.h"
#include "util/interrupt.h"

namespace tyg {

GnuplotOutcome runGnuplot(const std::filesystem::path& folder, const std::string& script,
                          const std::vector<std::string>& definitions) {
  using Kind = GnuplotOutcome::Kind;
  constexpr double kLongest = 300;  // s; a chart takes some seconds
  std::string statements;
  for (const std::string& definition : definitions) statements += definition + ";";
  try {
    ChildProcess gnuplot({"gnuplot", "-d", "-e", statements, script}, folder, interrupted);
    const ChildProcess::Ending ending = gnuplot.wait(kLongest);
    const bool late = ending.kind == ChildProcess::Ending::Kind::TooLate;
    return {ending.good() ? Kind::Drawn : Kind::Failed,
            late ? fmt::format("it was not done after {:g} s\n", kLongest) : gnuplot.printed()};
  } catch (const std::system_error& error) {
    const bool missing = error.code() == std::errc::no_such_file_or_directory;
    return {missing ? Kind::Missing : Kind::Failed, error.code().message()};
  }
}

std::string gnuplotQuoted(const std::string& text) {
  // Letters, digits and these marks mean nothing to gnuplot; nor do bytes of longer characters.
  constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789 .,:;=+-*/%&()<>_";
  std::string quoted = "\"";
  bool wasEscaped = false;
  for (const char character : text) {
    const auto byte = static_cast<unsigned char>(character);
    const bool extendsEscape = wasEscaped && byte >= '0' && byte <= '7';
    wasEscaped = extendsEscape || (byte < 0x80 && kPlain.find(character) == std::string_view::npos);
    quoted += wasEscaped ? fmt::format("\\{:03o}", byte) : std::string(1, character);
  }
  return quoted + "\"";
}

std::string chartColour(std::size_t k) { return fmt::format("#{:06x}", colourOfSeries(k).onLight); }

int gnuplotType(Mark mark) {
  constexpr std::array kTypes{8, 6, 4, 10, 12, 14};  // in the order of Mark
  return kTypes.at(static_cast<std::size_t>(mark));
}

}  // namespace tyg

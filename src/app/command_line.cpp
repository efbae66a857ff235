// Understands the command line with CLI11, runs the chosen command, and turns every failure into one message.
#include "app/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>
#include <system_error>
#include <vector>

#include "app/commands/commands.h"
#include "app/output/exit_code.h"
#include "app/output/standard_streams.h"
#include "util/standard_files.h"
#include "util/sudden_end.h"
#include "util/suggestion.h"
#include "util/text.h"

namespace tyg {
namespace {

constexpr const char* kAbout =
    R"(Tyg, an interactive cloth viewer: a sheet of particles joined by springs, moved by the method that
you name. `tyg` alone opens the window with the curtain, `tyg flag` opens it with the flag. Space
starts the cloth, and a left click pushes it.)";

constexpr const char* kMore = R"(SCENE is a built-in name (tyg list shows them) or the path of a .toml file.

Examples:
  tyg                                    the curtain in a window
  tyg view poke --integrator leapfrog    another scene, another method
  tyg run curtain --duration 5           simulate, without a window
  tyg run --help                         every option of a command, with its unit and default

Exit codes: 0 done; 1 the simulation failed; 2 wrong input or usage, or an output that cannot be
written; 130 interrupted by Ctrl-C (files that were not finished are not written).)";

std::vector<std::string> commandNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

bool isBuiltin(const std::string& name) {
  return std::ranges::any_of(builtinScenes(), [&](const BuiltinScene& scene) { return scene.name == name; });
}

/// `view` may be left out: `tyg`, `tyg flag` and `tyg --window glut` mean it. A first word that is neither command nor
/// scene is refused here, where both can be named.
void insertView(const CLI::App& app, std::vector<std::string>& words) {
  const std::string first = words.empty() ? "" : words.front();
  const std::vector<std::string> commands = commandNames(app);
  if (first == "--help" || first == "-h" || first == "--version" || std::ranges::count(commands, first) > 0) return;
  const bool isWord = !first.empty() && first.front() != '-';
  std::error_code ignored;
  if (isWord && !isBuiltin(first) && !first.ends_with(".toml") && !std::filesystem::exists(first, ignored)) {
    std::vector<std::string> scenes;
    for (const BuiltinScene& scene : builtinScenes()) scenes.emplace_back(scene.name);
    std::vector<std::string> both = commands;
    both.insert(both.end(), scenes.begin(), scenes.end());
    throw InputError("found '" + first + "', which is neither a command (" + joined(commands) + ") nor a scene (" +
                     joined(scenes) + ", or the path of a .toml file)" + didYouMean(first, both));
  }
  words.insert(words.begin(), "view");
}

std::vector<std::string> optionNames(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    names.push_back(option->get_positional() ? option->get_name(true) : "--" + option->get_lnames().front());
  }
  return names;
}

/// CLI11 says what is wrong; this adds what is allowed and where it is explained.
int explain(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  const CLI::App& command = chosen.empty() ? app : *chosen.front();
  const std::string name = chosen.empty() ? "tyg" : "tyg " + command.get_name();
  std::cerr << name << ": " << error.what();
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError)) {
    const std::vector<std::string> names = optionNames(command), left = command.remaining(true);
    const auto unknown = std::ranges::find_if(left, [](const std::string& word) { return word.starts_with("-"); });
    std::cerr << "\nAllowed: " << joined(names) << (unknown == left.end() ? "" : didYouMean(*unknown, names));
  }
  std::cerr << "\nTry: " << name << " --help" << std::endl;
  return kWrongInput;
}

enum class Wanted { Read, Run };

int parseAndRun(CLI::App& app, std::vector<std::string> words, Wanted wanted) {
  Action action;
  addViewCommand(app, action);
  addRunCommand(app, action);
  addRenderCommand(app, action);
  addExportCommand(app, action);
  addPlotCommand(app, action);
  addChartCommand(app, action);
  addStabilityCommand(app, action);
  addLimitCommand(app, action);
  addDietCommand(app, action);
  addAdviseCommand(app, action);
  addCheckCommand(app, action);
  addReferenceCommand(app, action);
  addListCommand(app, action);
  app.require_subcommand(1);
  try {
    insertView(app, words);
    std::ranges::reverse(words);  // the order in which CLI11 takes them
    app.parse(std::move(words));
  } catch (const CLI::ParseError& error) {
    return error.get_exit_code() == 0 ? app.exit(error) : explain(app, error);
  }
  return wanted == Wanted::Run ? action() : kDone;
}

int guarded(const std::vector<std::string>& words, Wanted wanted) {
  try {
    CLI::App app{kAbout, "tyg"};
    app.get_formatter()->column_width(34);
    app.set_help_flag("-h,--help", "Print this help and leave");
    app.set_version_flag("--version", "tyg " TYG_VERSION, "Print the version and leave");
    app.footer(kMore);
    const int code = parseAndRun(app, words, wanted);
    std::cout.flush();
    if (!std::cout)
      throw InputError("standard output: found one that cannot be written, allowed is a file, a pipe or a terminal");
    return code;
  } catch (const InputError& error) {
    std::cerr << "tyg: " << error.what() << std::endl;
    return kWrongInput;
  } catch (const std::bad_alloc&) {
    std::cerr << "tyg: there is not enough memory for this scene; a smaller sheet may fit (--sheet CxR)" << std::endl;
  } catch (const std::filesystem::filesystem_error& error) {
    std::cerr << "tyg: cannot use '" << error.path1().string() << "': " << error.code().message()
              << "; allowed: a path whose folders exist and may be read" << std::endl;
    return kWrongInput;
  } catch (const std::system_error& error) {
    std::cerr << "tyg: the system refused: " << error.what() << std::endl;
  } catch (const std::exception& error) {
    std::cerr << "tyg: stopped by a fault of its own (" << error.what() << "); please report what you typed"
              << std::endl;
  }
  return kSimulationFailed;
}

}  // namespace

int runCommandLine(int argc, char** argv) {
  prepareStandardFiles();
  prepareForSuddenEnd();
  HarmlessOutput harmlessResults(std::cout), harmlessMessages(std::cerr);
  return guarded(programWords(argc, argv), Wanted::Run);
}

int readCommandLine(const std::vector<std::string>& words) { return guarded(words, Wanted::Read); }

}  // namespace tyg

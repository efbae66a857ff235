// What a command takes on the command line: its options and flags, with their help, checks and rules.
// CLI11 reads them, but its header takes seconds to compile in each file, so only command_options.cpp and
// command_line.cpp include it. Must not know: scenes, what the commands do.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace tyg {

/// Says what is wrong with the text of a value; empty where it is good. See option_checks.h.
using OptionCheck = std::function<std::string(const std::string&)>;

/// One option of a command: a handle that may be copied.
class CommandOption {
 public:
  explicit CommandOption(CLI::Option* option) : option_(option) {}

  CommandOption& check(const OptionCheck& check);
  /// What the help shows in place of the value, such as "FILE.csv".
  CommandOption& typeName(const std::string& name);
  /// The heading of the help under which the option is listed.
  CommandOption& group(const std::string& heading);
  /// The two may not be given together.
  CommandOption& excludes(const CommandOption& other);

  /// Whether the command line has it. Known once the command line is read.
  [[nodiscard]] bool given() const;

 private:
  CLI::Option* option_;
};

/// A command of the program while its options are declared: a handle that may be copied. The values that options are
/// read into must live until the command line has been read; what they hold before is their default.
class Command {
 public:
  Command(CLI::App& app, const std::string& name, const std::string& description);

  CommandOption option(const std::string& name, std::string& value, const std::string& help);
  CommandOption option(const std::string& name, int& value, const std::string& help);
  CommandOption option(const std::string& name, std::optional<std::string>& value, const std::string& help);
  /// An amount that `read` makes of the text; the InputError that it throws is the refusal.
  CommandOption amount(const std::string& name, std::optional<double>& value,
                       const std::function<double(const std::string&)>& read, const std::string& help);
  CommandOption option(const std::string& name, std::optional<int>& value, const std::string& help);
  void flag(const std::string& name, bool& value, const std::string& help);
  /// An option that has been declared.
  [[nodiscard]] CommandOption find(const std::string& name) const;
  /// What the help says below the options.
  void footer(const std::string& text);
  /// What happens when the command line is read and names this command.
  void onChosen(const std::function<void()>& chosen);

 private:
  CLI::App* app_;
};

}  // namespace tyg

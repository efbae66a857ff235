// Each call is handed on to CLI11, whose templates are compiled here for the kinds of values that commands have.
#include "app/commands/command_options.h"

#include <CLI/CLI.hpp>

#include "tyg/input_error.h"

namespace tyg {

CommandOption& CommandOption::check(const OptionCheck& check) {
  option_->check(check);
  return *this;
}

CommandOption& CommandOption::typeName(const std::string& name) {
  option_->type_name(name);
  return *this;
}

CommandOption& CommandOption::group(const std::string& heading) {
  option_->group(heading);
  return *this;
}

CommandOption& CommandOption::excludes(const CommandOption& other) {
  option_->excludes(other.option_);
  return *this;
}

bool CommandOption::given() const { return option_->count() > 0; }

Command::Command(CLI::App& app, const std::string& name, const std::string& description)
    : app_(app.add_subcommand(name, description)) {}

CommandOption Command::option(const std::string& name, std::string& value, const std::string& help) {
  return CommandOption(app_->add_option(name, value, help));
}

CommandOption Command::option(const std::string& name, int& value, const std::string& help) {
  return CommandOption(app_->add_option(name, value, help));
}

CommandOption Command::option(const std::string& name, std::optional<std::string>& value, const std::string& help) {
  return CommandOption(app_->add_option(name, value, help));
}

CommandOption Command::amount(const std::string& name, std::optional<double>& value,
                              const std::function<double(const std::string&)>& read, const std::string& help) {
  const auto take = [&value, read](const std::string& text) {
    try {
      value = read(text);
    } catch (const InputError& refusal) {
      throw CLI::ValidationError(refusal.what());
    }
  };
  return CommandOption(app_->add_option_function<std::string>(name, take, help));
}

CommandOption Command::option(const std::string& name, std::optional<int>& value, const std::string& help) {
  return CommandOption(app_->add_option(name, value, help));
}

void Command::flag(const std::string& name, bool& value, const std::string& help) { app_->add_flag(name, value, help); }

CommandOption Command::find(const std::string& name) const { return CommandOption(app_->get_option(name)); }

void Command::footer(const std::string& text) { app_->footer(text); }

void Command::onChosen(const std::function<void()>& chosen) { app_->callback(chosen); }

}  // namespace tyg

// Starts the program through the shell and reads its JSON with a parser that is not the program's own writing.
#include "app/program.h"

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

namespace tyg {

Outcome tyg(const std::string& arguments, const std::string& before) {
  const Folder folder;
  const std::string out = (folder / "out").string(), err = (folder / "err").string();
  const std::string command = before + " '" TYG_PROGRAM "' " + arguments + " >'" + out + "' 2>'" + err + "' </dev/null";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contentsOf(out), contentsOf(err)};
}

std::string jsonValue(const std::string& json, const std::string& path) {
  const auto parsed = nlohmann::json::parse(json);
  const nlohmann::json::json_pointer pointer("/" + path);
  return parsed.contains(pointer) ? parsed[pointer].dump() : "missing";
}

std::vector<std::string> jsonKeys(const std::string& json) {
  using Event = nlohmann::json::parse_event_t;
  std::vector<std::string> keys;
  [[maybe_unused]] const auto all =
      nlohmann::json::parse(json, [&](int /*depth*/, Event event, const nlohmann::json& parsed) {
        if (event == Event::key) keys.push_back(parsed);
        return true;
      });
  return keys;
}

bool isFlatJson(const std::string& text) {
  const auto parsed = nlohmann::json::parse(text, nullptr, false);
  return parsed.is_object() && std::ranges::all_of(parsed, [](const nlohmann::json& value) {
           return value.is_number() || value.is_string() || value.is_boolean() || value.is_null();
         });
}

}  // namespace tyg

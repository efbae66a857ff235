// `tyg list`: the built-in scenes and the methods, for people (80 columns) or as JSON.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "app/command_line.h"
#include "app/commands/commands.h"
#include "app/reports/json.h"
#include "tyg/methods.h"
#include "util/text.h"

namespace tyg {
namespace {

constexpr std::size_t kPageWidth = 80, kNameWidth = 20;

/// The words of a text in lines that fit between `indent` and the edge of the page.
std::string wrapped(const std::string& text, std::size_t indent) {
  std::istringstream words(text);
  std::string page, line, word;
  const std::string margin(indent, ' ');
  while (words >> word) {
    if (!line.empty() && indent + line.size() + 1 + word.size() > kPageWidth) {
      page += margin + line + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return page + margin + line + "\n";
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size() + 1), ' ');
  return text;
}

enum class Kind { Showing, Failing };
std::vector<Scene> scenes(Kind kind) {
  std::vector<Scene> all;
  for (const BuiltinScene& scene : builtinScenes()) {
    if (showsFailure(scene) == (kind == Kind::Failing))
      all.push_back(loadScene(std::string(scene.name), methodNames()));
  }
  return all;
}

std::string evaluations(const Method& method) {
  if (method.evaluationsPerStep < 0) return "evaluations as needed";
  return std::to_string(method.evaluationsPerStep) + (method.adaptive ? " a step of its own choice" : " a step");
}

std::string described(Kind kind) {
  std::string text;
  for (const Scene& scene : scenes(kind)) {
    const std::string size = std::to_string(scene.columns) + " x " + std::to_string(scene.rows);
    text += "  " + padded(scene.name, kNameWidth) + scene.title + " (" + size + " particles)\n";
    text += wrapped(scene.shows, kNameWidth + 2);
  }
  return text;
}

std::string page() {
  std::string text = "Scenes (for example: tyg view NAME; the path of a .toml file serves as well)\n\n";
  text += described(Kind::Showing);
  text += "\nScenes that fail (tyg run NAME exits with 1 and says why and what to do)\n\n";
  text += described(Kind::Failing);
  text += "\nMethods (--integrator NAME), with their order and force evaluations\n\n";
  for (const Method& method : methods()) {
    text += "  " + padded(std::string(method.name), kNameWidth) + std::string(method.label) + ": order " +
            std::to_string(method.order) + ", " + evaluations(method) + "\n";
    text += wrapped(std::string(method.scheme), kNameWidth + 2);
  }
  return text;
}

std::string listed(const std::vector<JsonObject>& objects) { return "[" + joined(objects, &JsonObject::text) + "]"; }

std::string json() {
  std::vector<JsonObject> sceneObjects, methodObjects;
  for (const Kind kind : {Kind::Showing, Kind::Failing}) {
    for (const Scene& scene : scenes(kind)) {
      JsonObject& object = sceneObjects.emplace_back();
      object.add("name", scene.name);
      object.add("title", scene.title);
      object.add("shows", scene.shows);
      object.add("columns", scene.columns);
      object.add("rows", scene.rows);
      object.addRaw("fails", kind == Kind::Failing ? "true" : "false");
    }
  }
  for (const Method& method : methods()) {
    JsonObject& object = methodObjects.emplace_back();
    object.add("name", method.name);
    object.add("label", method.label);
    object.add("scheme", method.scheme);
    object.add("order", method.order);
    object.addRaw("evaluations_per_step",
                  method.evaluationsPerStep < 0 ? "null" : std::to_string(method.evaluationsPerStep));
    object.addRaw("adaptive", method.adaptive ? "true" : "false");
  }
  JsonObject all;
  all.addRaw("scenes", listed(sceneObjects));
  all.addRaw("methods", listed(methodObjects));
  return all.text() + "\n";
}

}  // namespace

void addListCommand(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("list", "Show the built-in scenes and the methods");
  const auto asJson = std::make_shared<bool>(false);
  command->add_flag("--json", *asJson, "Print one JSON object with the keys scenes and methods");
  command->footer("Examples:\n  tyg list\n  tyg list --json");
  command->callback([asJson, &action] {
    action = [asJson] {
      std::cout << (*asJson ? json() : page()) << std::flush;
      return kDone;
    };
  });
}

}  // namespace tyg

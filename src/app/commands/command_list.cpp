// `tyg list`: the built-in scenes and the methods, for people (80 columns) or as JSON.
#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#include "app/output/exit_code.h"
#include "app/reports/json.h"
#include "tyg/methods.h"
#include "util/wrapped.h"

namespace tyg {
namespace {

constexpr std::size_t kPageWidth = 80, kNameWidth = 20;

/// A text in lines that fit between `indent` and the edge of the page.
std::string indented(std::string_view text, std::size_t indent) {
  const std::string blanks(indent, ' ');
  return blanks + paragraph(text, blanks, int(kPageWidth - indent));
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
  return fmt::format("{} a step{}", method.evaluationsPerStep, method.adaptive ? " of its own choice" : "");
}

std::string described(Kind kind) {
  std::string text;
  for (const Scene& scene : scenes(kind)) {
    text += fmt::format("  {:<{}}{} ({} x {} particles)\n", scene.name + " ", kNameWidth, scene.title, scene.columns,
                        scene.rows);
    text += indented(scene.shows, kNameWidth + 2);
  }
  return text;
}

std::string page() {
  std::string text = "Scenes (use one with tyg view NAME; the path of a .toml file works too)\n\n";
  text += described(Kind::Showing);
  text += "\nScenes that fail (tyg run NAME exits with 1 and says why and what to do)\n\n";
  text += described(Kind::Failing);
  text += "\nMethods (--integrator NAME), with their order and force evaluations\n\n";
  for (const Method& method : methods()) {
    text += fmt::format("  {:<{}}{}: order {}, {}\n", std::string(method.name) + " ", kNameWidth, method.label,
                        method.order, evaluations(method));
    text += indented(method.scheme, kNameWidth + 2);
  }
  return text;
}

Json scenesJson() {
  Json list = Json::array();
  for (const Kind kind : {Kind::Showing, Kind::Failing}) {
    for (const Scene& scene : scenes(kind)) {
      list.append({{"name", scene.name},
                   {"title", scene.title},
                   {"shows", scene.shows},
                   {"columns", scene.columns},
                   {"rows", scene.rows},
                   {"fails", kind == Kind::Failing}});
    }
  }
  return list;
}

Json methodsJson() {
  Json list = Json::array();
  for (const Method& method : methods()) {
    list.append({{"name", method.name},
                 {"label", method.label},
                 {"scheme", method.scheme},
                 {"order", method.order},
                 {"evaluations_per_step", method.evaluationsPerStep < 0 ? Json() : Json(method.evaluationsPerStep)},
                 {"adaptive", method.adaptive}});
  }
  return list;
}

std::string json() { return jsonText({{"scenes", scenesJson()}, {"methods", methodsJson()}}) + "\n"; }

}  // namespace

void addListCommand(CLI::App& app, Action& action) {
  Command command(app, "list", "Show the built-in scenes and the methods");
  const auto asJson = std::make_shared<bool>(false);
  command.flag("--json", *asJson, "Print one JSON object with the keys scenes and methods");
  command.footer("Examples:\n  tyg list\n  tyg list --json");
  command.onChosen([asJson, &action] {
    action = [asJson] {
      std::cout << (*asJson ? json() : page()) << std::flush;
      return kDone;
    };
  });
}

}  // namespace tyg

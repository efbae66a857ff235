// `tyg limit`: the largest stable step of every method for springs given on the command line.
#include <algorithm>
#include <iostream>
#include <memory>

#include <fmt/core.h>

#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#include "app/commands/option_checks.h"
#include "app/output/exit_code.h"
#include "app/output/progress.h"
#include "app/reports/limit_report.h"
#include "core/scene/scene_range.h"
#include "tyg/input_error.h"
#include "tyg/methods.h"
#include "util/amounts.h"
#include "util/interrupt.h"

namespace tyg {
namespace {

struct LimitOptions {
  std::string ks, kd = "0", sheet = "20x20", damping = "relative";
  std::optional<std::string> methods;
  std::optional<double> mass, spacing, drag, dt;  // kg, m, N s/m, s
  bool json = false;
};

constexpr const char* kExamples =
    R"(For your own program: give its springs, and see how large its step may be, with each method.
Springs join neighbours along rows and columns (structural), across cells (shear), and next
neighbours but one (bend). The sheet is taken as free of pins, which only loosen its limits.

Examples:
  tyg limit --ks 1200,900,200 --kd 0.1 --mass 18g
  tyg limit --ks 1200,900,200 --kd 0.1 --mass 18g --dt 5ms --methods rk4
  tyg limit --ks 500 --mass 1g --sheet 1x30 --json

Exit codes: 0 done; 1 the step of --dt does not hold with every method asked for; 2 wrong input.)";

/// One to three numbers, not below 0, with commas between; families that are not named are 0.
std::vector<double> numbersOf(const std::string& option, const std::string& text) {
  const std::vector<std::string> parts = splitList(text);
  if (parts.empty() || parts.size() > 3 || std::ranges::count(text, ',') != std::ptrdiff_t(parts.size()) - 1) {
    throw InputError(fmt::format(
        "{}: found '{}', allowed are one to three numbers with commas between: structural, shear, bend", option, text));
  }
  std::vector<double> numbers;
  numbers.reserve(parts.size());
  for (const std::string& part : parts) numbers.push_back(parseNumber(option, part, Zero::Allowed));
  return numbers;
}

Scene sheetOf(const LimitOptions& options) {
  if (options.ks.empty() || !options.mass) {
    throw InputError(
        fmt::format("limit: found no {}, needed are --ks (N/m) and --mass (of a particle), such as "
                    "tyg limit --ks 1200,900,200 --kd 0.1 --mass 18g",
                    options.ks.empty() ? "--ks" : "--mass"));
  }
  Scene scene;
  scene.name = "tyg limit";
  const auto [columns, rows] = parsePair(options.sheet);
  scene.columns = columns, scene.rows = rows;
  scene.spacing = options.spacing.value_or(0.1);
  scene.particleMass = *options.mass;
  scene.drag = options.drag.value_or(0);
  scene.damping = options.damping == "axial" ? Damping::Axial : Damping::Relative;
  const std::vector<double> ks = numbersOf("--ks", options.ks), kd = numbersOf("--kd", options.kd);
  SpringFamily* const families[] = {&scene.structural, &scene.shear, &scene.bend};
  for (std::size_t k = 0; k < std::size(families); ++k) {
    families[k]->ks = k < ks.size() ? ks[k] : 0;
    // One kd serves all springs that there are.
    families[k]->kd = kd.size() == 1 ? (families[k]->ks > 0 ? kd[0] : 0) : k < kd.size() ? kd[k] : 0;
  }
  refuseExtremes(scene);
  return scene;
}

int limit(const LimitOptions& options) {
  SceneOptions named;
  named.integrator = options.methods;
  LimitReport report{.scene = sheetOf(options), .dt = options.dt, .methods = {}};
  const InterruptWatch watch;
  auto progress = std::make_unique<Progress>("tyg limit");
  const std::vector<const Method*> asked = chosenMethods(named);
  for (const Method* method : asked) {
    if (!progress->show(double(report.methods.size()) / double(asked.size()))) {
      progress.reset();
      return sayInterrupted("tyg limit", "nothing was printed");
    }
    report.methods.push_back(limitOf(report.scene, *method, options.dt));
  }
  progress.reset();  // wipes its line
  std::cout << (options.json ? limitJson(report) : limitTable(report)) << std::flush;
  return report.holds() ? kDone : kSimulationFailed;
}

void addNumbers(Command& command, LimitOptions& options) {
  const auto number = [](const char* option) {
    return [=](const std::string& text) { return parseNumber(option, text, Zero::Allowed); };
  };
  command.option("--ks", options.ks, "Stiffness of structural, shear and bend springs, N/m; 0 where there are none")
      .typeName("S[,SH[,B]]");
  command.option("--kd", options.kd, "Damping, N s/m: one number for all springs, or one a family [0]")
      .typeName("S[,SH[,B]]");
  command
      .amount(
          "--mass", options.mass, [](const std::string& text) { return parseMass("--mass", text); },
          "Mass of a particle, such as 18g")
      .typeName("MASS");
  command.option("--sheet", options.sheet, "Columns x rows of particles [20x20]")
      .check([](const std::string& text) { return checkPair(text, kLargestCount, "columns x rows, such as 40x30"); })
      .typeName("CxR");
  command
      .amount(
          "--spacing", options.spacing, [](const std::string& text) { return parseLength("--spacing", text, 0); },
          "Distance of neighbours at rest, such as 5cm [0.1]")
      .typeName("LENGTH");
  command.option("--damping", options.damping, "Law of the springs' damping: relative or axial [relative]")
      .check([](const std::string& text) {
        return checkOneOf(text, {"relative", "axial"});
      })
      .typeName("LAW");
  command.amount("--drag", options.drag, number("--drag"), "Drag on a particle, N s/m [0]").typeName("D");
}

}  // namespace

void addLimitCommand(CLI::App& app, Action& action) {
  Command command(app, "limit", "The largest stable step of every method for given springs; no scene needed");
  const auto options = std::make_shared<LimitOptions>();
  addNumbers(command, *options);
  command
      .amount(
          "--dt", options->dt, [](const std::string& text) { return parseTime("--dt", text); },
          "Say whether this step holds, such as 2ms, and what would make it hold")
      .typeName("TIME");
  command.option("--integrator,--methods", options->methods, "Methods with commas between [all]").typeName("NAME,...");
  command.flag("--json", options->json, "Print one JSON object");
  command.footer(kExamples);
  command.onChosen([options, &action] { action = [options] { return limit(*options); }; });
}

}  // namespace tyg

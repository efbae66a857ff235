// The words of step limits, and of what would make a step hold.
#include "app/reports/limit_report.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/reports/json.h"
#include "tyg/methods.h"
#include "util/amounts.h"
#include "util/text.h"
#include "util/wrapped.h"

namespace tyg {
namespace {

constexpr std::string_view kIndent = "  ";  // of all lines of a paragraph but the first

std::string stepCell(double step) {
  if (std::isnan(step)) return "-";
  return step == 0 ? "none" : timeText(step);
}

/// `a`, `a and b`, `a, b and c`.
std::string withAnd(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k) {
    text += (k == 0 ? "" : k + 1 == words.size() ? " and " : ", ") + words[k];
  }
  return text;
}

std::string setBy(const LimitOfMethod& of) {
  if (std::isnan(of.limit.predicted)) return of.method->whyNoLimit.empty() ? "nothing" : "nothing: stable at any step";
  if (of.limit.predicted == 0) return "a lack of damping";
  if (of.limit.damper != nullptr) return fmt::format("{} on the particles", of.limit.damper->name);
  return fmt::format("{} of {} springs", causeOf(of.limit), withAnd(of.springs));
}

int answerWidth(const LimitReport& report) { return report.dt ? 15 : 0; }

std::string tableLine(const LimitReport& report, const LimitOfMethod& of) {
  const std::string answer = !report.dt ? "" : of.holds ? "holds" : "does not hold";
  return fmt::format("{:<17}{:>9}  {:>9}  {:<{}}{}\n", of.method->name, stepCell(of.limit.predicted),
                     stepCell(of.limit.certified), answer, answerWidth(report), setBy(of));
}

/// `division by 1.5` of a number that becomes smaller, `times 1.5` of one that grows.
std::string scaled(double factor) {
  return factor < 1 ? fmt::format("divided by {:.3g}", 1 / factor) : fmt::format("times {:.3g}", factor);
}

/// What would make the step of a method hold, in its order of size: the step, then the others.
std::vector<std::string> remedies(const LimitReport& report, const LimitOfMethod& of) {
  const HoldingChanges& changes = of.changes.value();
  std::vector<std::pair<double, std::string>> found;
  const auto add = [&](double factor, std::string words) {
    if (factor > 0 && std::isfinite(factor)) found.emplace_back(std::abs(std::log(factor)), std::move(words));
  };
  const double step = changes.dt / report.dt.value(), mass = changes.mass / report.scene.particleMass;
  add(step, fmt::format("steps of {} (divided by {:.3g})", timeText(changes.dt), 1 / step));
  add(changes.stiffness, "all ks " + scaled(changes.stiffness));
  add(mass, fmt::format("particles of {:.3g} kg (times {:.3g})", changes.mass, mass));
  if (const double kd = report.scene.structural.kd; kd > 0) {
    add(changes.damping / kd,
        fmt::format("all kd {} (to {:.3g} N s/m)", scaled(changes.damping / kd), changes.damping));
  } else if (changes.damping > 0) {
    found.emplace_back(std::numeric_limits<double>::infinity(),
                       fmt::format("a kd of {:.3g} N s/m for all springs", changes.damping));
  }
  std::ranges::stable_sort(found, {}, &std::pair<double, std::string>::first);
  std::vector<std::string> words;
  words.reserve(found.size());
  for (const auto& [size, each] : found) words.push_back(each);
  return words;
}

/// The methods of all that hold the step as the sheet is, those that compute least for it first.
std::string whoHolds(const Scene& scene, double dt) {
  std::vector<const Method*> holding;
  for (const Method& method : methods()) {
    if (method.advisable && holdsAtRest(scene, method, dt)) holding.push_back(&method);
  }
  std::ranges::stable_sort(holding, {}, [](const Method* method) {
    return std::pair(method->solves || method->evaluationsPerStep < 0, method->evaluationsPerStep);
  });
  if (holding.empty()) return "";
  return paragraph(fmt::format("Methods that hold {} on this sheet as it is: {}.", timeText(dt),
                               joined(holding, [](const Method* method) { return std::string(method->name); })),
                   kIndent);
}

Json changesJson(const HoldingChanges& changes) {
  return {{"dt", changes.dt > 0 ? Json(changes.dt) : Json()},
          {"ks_factor", Json(changes.stiffness)},
          {"structural_kd", Json(changes.damping)},
          {"mass", Json(changes.mass)}};
}

}  // namespace

bool LimitReport::holds() const { return std::ranges::all_of(methods, &LimitOfMethod::holds); }

LimitOfMethod limitOf(const Scene& scene, const Method& method, std::optional<double> dt) {
  LimitOfMethod of{.method = &method,
                   .limit = stepLimit(scene, method),
                   .springs = {},
                   .holds = !dt || holdsAtRest(scene, method, *dt),
                   .changes = {}};
  of.springs = springsThatLimit(scene, method, of.limit.byDamping);
  if (!of.holds) of.changes = changesThatHold(scene, method, *dt);
  return of;
}

std::string limitTable(const LimitReport& report) {
  std::string text = fmt::format("{:<17}{:>9}  {:>9}  {:<{}}set by\n", "largest step of", "at rest", "certified",
                                 report.dt ? timeText(*report.dt) : "", answerWidth(report));
  for (const LimitOfMethod& of : report.methods) text += tableLine(report, of);
  text += "\n" + paragraph(
                     "At rest: larger steps make the cloth at rest explode. Certified: no smaller step is unstable, "
                     "however the cloth is stretched or folded. -: there is no such step, or none is needed. bs32 "
                     "and dopri54 are taken with fixed steps.",
                     kIndent);
  if (!report.dt || report.holds()) return text;
  text += "\nAny one of these changes alone makes the step hold, the smallest first:\n";
  for (const LimitOfMethod& of : report.methods) {
    if (of.holds) continue;
    const std::vector<std::string> words = remedies(report, of);
    text += paragraph(fmt::format("  {}: {}.", of.method->name,
                                  words.empty() ? "no change of the step, the springs or the mass" : joined(words)),
                      kIndent);
  }
  return text + whoHolds(report.scene, *report.dt);
}

std::string limitJson(const LimitReport& report) {
  Json list = Json::array();
  for (const LimitOfMethod& of : report.methods) {
    const bool hasLimit = of.limit.predicted > 0;
    Json springs = Json::array();
    for (const std::string& name : of.springs) springs.append(name);
    Json entry{{"integrator", of.method->name},
               {"stable_dt", Json(of.limit.predicted)},
               {"certified_dt", Json(of.limit.certified)},
               {"set_by", hasLimit ? Json(causeOf(of.limit)) : Json()},
               {"springs", springs}};
    if (report.dt) {
      entry.update({{"holds", of.holds}, {"changes", of.changes ? changesJson(*of.changes) : Json()}});
    }
    list.append(entry);
  }
  Json object{{"methods", list}};
  if (report.dt) object.update({{"dt", Json(*report.dt)}, {"holds", report.holds()}});
  return jsonText(object) + "\n";
}

}  // namespace tyg

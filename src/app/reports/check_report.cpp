// The verdict comes first: whoever reads no further knows what to do.
#include "app/reports/check_report.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/reports/json.h"
#include "util/amounts.h"
#include "util/csv.h"
#include "util/visible_text.h"
#include "util/wrapped.h"

namespace tyg {
namespace {

std::string metres(double distance) {
  if (std::isinf(distance)) return "infinite";
  return distance >= 1 ? lengthText(distance) : fmt::format("{:.2g} m", distance);
}

std::string shareText(double share) {
  constexpr double kBeyondReading = 1e6;
  const double percent = 100 * share;
  if (!std::isfinite(percent)) return "";
  const std::string number =
      percent >= 10 && percent < kBeyondReading ? fmt::format("{:.0f}", percent) : fmt::format("{:.2g}", percent);
  return ", " + number + " % of the sheet's size";
}

/// The floor of the sheet at the sample of the reference that is the next after a time, m.
double floorAt(const MotionCheck& check, double time) {
  const std::vector<double>& times = check.reference.motion.times;
  const auto next = std::ranges::lower_bound(times, time * (1 - 1e-12));
  const auto sample = std::size_t(std::min(next, times.end() - 1) - times.begin());
  return check.reference.floorAt(sample, Precision::Double);
}

std::string methodText(const Explanation& of) {
  return fmt::format("{}{}", of.way.name(), of.dt > 0 ? " at " + timeText(of.dt) : ", steps of its own choice");
}

/// Where the error was at some of the times.
std::string errorTable(const CheckReport& report) {
  constexpr std::size_t kRows = 8;
  const MotionCheck& check = report.check;
  std::string text = fmt::format("{:>12}  {:>14}  {:>16}  {:>9}\n", "time", "error", "explained to", "floor");
  const std::size_t count = check.errors.size(), rows = std::min(kRows, count);
  for (std::size_t row = 1; row <= rows; ++row) {
    const std::size_t k = row * count / rows - 1;
    const double time = report.motion.times[k];
    text += fmt::format("{:>12}  {:>14}  {:>16}  {:>9}\n", timeText(time), metres(check.errors[k]),
                        k < check.explained.size() ? metres(check.explained[k]) : "-", metres(floorAt(check, time)));
  }
  return text;
}

std::string horizonLine(const MotionCheck& check) {
  const double horizon = check.reference.horizonOf(check.error, Precision::Double);
  if (check.error == 0 || horizon >= check.scene.duration) return "";
  if (!(horizon > 0)) return paragraph("The truth is known only to the floor: an error of this size tells no more.");
  return paragraph(fmt::format("The truth is known only to the floor: past {} an error of this size tells nothing.",
                               timeText(horizon)));
}

}  // namespace

std::string checkTable(const CheckReport& report) {
  const MotionCheck& check = report.check;
  std::string text = paragraph(verdictWords(check)) + "\n" + errorTable(report) + "\n";
  text += fmt::format("error E          {}{}\n", metres(check.error), shareText(check.error / check.size));
  if (const Explanation* of = check.explanation()) {
    text += fmt::format("nearest method   {}, {} away\n", methodText(*of),
                        metres(check.mistaken ? check.withoutMistake : of->distance));
    if (check.mistaken) {
      text += fmt::format("mistake          {}: {} away\n", mistakeName(check), metres(of->distance));
    }
  }
  text += horizonLine(check);
  if (!check.tears.empty()) text += paragraph(check.tears);
  if (!report.within) return text;
  return text + fmt::format("asked for        {}: {}\n", lengthText(*report.within),
                            report.passes() ? "within it" : "the error is larger");
}

std::string checkJson(const CheckReport& report) {
  const MotionCheck& check = report.check;
  const double none = std::numeric_limits<double>::quiet_NaN();
  Json nearest;
  if (const Explanation* of = check.explanation()) {
    nearest = Json{{"integrator", of->way.name()},
                   {"dt", Json(of->dt > 0 ? of->dt : none)},
                   {"distance_m", Json(check.mistaken ? check.withoutMistake : of->distance)}};
  }
  const std::string mistake = mistakeName(check);
  Json times = Json::array();
  for (std::size_t k = 0; k < check.errors.size(); ++k) {
    times.append(Json{{"t", Json(report.motion.times[k])},
                      {"error_m", Json(check.errors[k])},
                      {"floor_m", Json(floorAt(check, report.motion.times[k]))}});
  }
  return jsonText(Json{{"scene", oneLine(check.scene.name)},
                       {"error_m", Json(check.error)},
                       {"error_size", Json(check.error / check.size)},
                       {"times", times},
                       {"nearest", nearest},
                       {"mistake", mistake.empty() ? Json() : Json(mistake)},
                       {"mistake_distance_m", Json(check.mistaken ? check.mistaken->distance : none)},
                       {"verdict", verdictWords(check)},
                       {"within", report.within ? Json(report.passes()) : Json()},
                       {"horizon_s", Json(check.reference.horizonOf(check.error, Precision::Double))},
                       {"stable_dt", Json(check.limit > 0 ? check.limit : none)}}) +
         "\n";
}

std::string checkCsv(const CheckReport& report) {
  const MotionCheck& check = report.check;
  std::string rows = "t,error_m,explained_m,floor_m\n";
  for (std::size_t k = 0; k < check.errors.size(); ++k) {
    const double time = report.motion.times[k], floor = floorAt(check, time);
    rows += k < check.explained.size() ? csvLine(time, check.errors[k], check.explained[k], floor)
                                       : csvLine(time, check.errors[k], "", floor);
  }
  return rows;
}

}  // namespace tyg

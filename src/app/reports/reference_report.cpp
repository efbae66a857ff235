// The floor is what errors below it mean nothing by: it grows with time as the cloth amplifies rounding errors.
#include "app/reports/reference_report.h"

#include <fmt/core.h>

#include "app/reports/json.h"
#include "util/amounts.h"
#include "util/visible_text.h"
#include "util/wrapped.h"

namespace tyg {
namespace {

constexpr double kPercent = 0.01;  // of the size: an error that most exercises allow

double floorAtEnd(const ReferenceReport& report) { return report.reference.floorOf(Precision::Double); }

double horizonOfPercent(const ReferenceReport& report) {
  return report.reference.horizonOf(kPercent * report.reference.size, Precision::Double);
}

}  // namespace

std::string referenceText(const ReferenceReport& report) {
  const SampledMotion& motion = report.motion;
  std::string text = fmt::format("{}: {} times up to {}, {} particles\n", oneLine(report.file), motion.times.size(),
                                 timeText(motion.times.back()), motion.positions.front().size());
  text += fmt::format("known to         {:.2g} m at the end, of a sheet of {}\n", floorAtEnd(report),
                      lengthText(report.reference.size));
  if (const double horizon = horizonOfPercent(report); horizon < report.reference.scene.duration) {
    text += paragraph(fmt::format(
        "Past {} rounding errors alone move this cloth by a tenth of a percent of its size and more: no two programs "
        "agree there.",
        timeText(horizon)));
  }
  if (!report.tears.empty()) text += paragraph(report.tears);
  return text;
}

std::string referenceJson(const ReferenceReport& report) {
  return jsonText(Json{{"scene", oneLine(report.scene.name)},
                       {"file", oneLine(report.file)},
                       {"samples", std::int64_t(report.motion.times.size())},
                       {"particles", std::int64_t(report.motion.positions.front().size())},
                       {"duration_s", Json(report.motion.times.back())},
                       {"size_m", Json(report.reference.size)},
                       {"floor_m", Json(floorAtEnd(report))},
                       {"horizon_s", Json(horizonOfPercent(report))}}) +
         "\n";
}

}  // namespace tyg

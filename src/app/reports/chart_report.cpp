// Numbers have two digits: more would promise more than timing and errors can tell.
#include "app/reports/chart_report.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/core.h>

#include "study/work/frontier.h"
#include "util/csv.h"
#include "util/text.h"

namespace tyg {
namespace {

std::string amplificationText(const Reference& reference) {
  const auto lost = std::ranges::find_if(reference.amplification, [](double a) { return a > Reference::kTwinLost; });
  if (lost != reference.amplification.end()) {
    const auto k = static_cast<std::size_t>(lost - reference.amplification.begin());
    return fmt::format("a disturbance grows a million times by t = {:.2g} s", reference.motion.times[k]);
  }
  const double most = std::ranges::max(reference.amplification);
  return most > 1 ? fmt::format("a small disturbance grows {:.2g} times", most)
                  : fmt::format("a small disturbance shrinks to {:.2g} of its size or less", most);
}

std::string costText(double cost, Cost kind) {
  return kind == Cost::Seconds ? fmt::format("{:.2g} ms", 1000 * cost) : std::to_string(std::llround(cost));
}

std::string winners(const WorkChart& chart, double error, Cost cost) {
  constexpr std::size_t kShown = 3;
  std::vector<Price> prices = pricesOf(chart.rows, error, cost);
  if (prices.empty()) return "none";
  prices.resize(std::min(kShown, prices.size()));
  return joined(prices, [&](const Price& price) {
    return fmt::format("{}{} {}", price.integrator, price.precision == Precision::Float ? " in float" : "",
                       costText(price.cost / chart.duration, cost));
  });
}

}  // namespace

std::vector<std::string> chartNotes(const Reference& reference, const std::string& machine, int threads) {
  const Scene& scene = reference.scene;
  return {fmt::format("{} x {} particles, {:g} s simulated; {}, {} thread{}; error: RMS distance over all particles "
                      "from the reference, the largest at {} times",
                      scene.columns, scene.rows, scene.duration, machine, threads, threads == 1 ? "" : "s",
                      reference.motion.times.size()),
          fmt::format("reference: dopri54 within {:.2g} m a step; rk4 in steps of {:.2g} s agrees to {:.2g} of the "
                      "size; {}",
                      scene.tolerance, reference.secondStep, reference.disagreement.back() / reference.size,
                      amplificationText(reference))};
}

std::string cheapestMethods(const WorkChart& chart) {
  std::string text = "error/size  cheapest by time (per simulated second); by force evaluations\n";
  for (const double error : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10}) {
    text += fmt::format("{:>10g}  {}; {}\n", error, winners(chart, error * chart.size, Cost::Seconds),
                        winners(chart, error * chart.size, Cost::Evaluations));
  }
  return text;
}

std::string speedChanges(const WorkChart& chart, const std::vector<WorkRow>& earlier) {
  const double longer = chart.duration / chart.comparedDuration.value_or(chart.duration);
  std::map<std::string, std::vector<double>> ratios;
  for (const WorkRow& row : chart.rows) {
    for (const WorkRow& old : earlier) {
      if (row.integrator == old.integrator && row.precision == old.precision && row.dt == old.dt &&
          row.tolerance == old.tolerance && row.status == RowStatus::Ok && row.seconds > 0 && old.seconds > 0) {
        ratios[row.integrator].push_back(row.seconds / old.seconds / longer);
      }
    }
  }
  std::string text;
  for (auto& [method, values] : ratios) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    text += fmt::format("{}: {:.2g} times the seconds of before per simulated second (middle of {} rows)\n", method,
                        *middle, values.size());
  }
  return text;
}

std::string sheetLines(const std::vector<SheetDistance>& sheets, double size) {
  std::string text;
  for (const SheetDistance& sheet : sheets) {
    text += fmt::format("the same cloth as {}x{} is {:.2g} of the size away (RMS), {:.2g} m at most\n",
                        sheet.grid.columns, sheet.grid.rows, sheet.distance.rms / size, sheet.distance.largest);
  }
  return text;
}

std::string sheetsCsv(const std::vector<SheetDistance>& sheets) {
  std::string text = csvLine("columns", "rows", "rms_distance_m", "max_distance_m");
  for (const SheetDistance& sheet : sheets) {
    text += csvLine(sheet.grid.columns, sheet.grid.rows, sheet.distance.rms, sheet.distance.largest);
  }
  return text;
}

}  // namespace tyg

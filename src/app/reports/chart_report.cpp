// Words and numbers of `tyg chart`.
#include "app/reports/chart_report.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>

#include "study/work/frontier.h"

namespace tyg {
namespace {

std::ostringstream stream() {
  std::ostringstream text;
  text << std::setprecision(2);
  return text;
}

std::string amplificationText(const Reference& reference) {
  std::ostringstream text = stream();
  const auto lost = std::ranges::find_if(reference.amplification, [](double a) { return a > Reference::kTwinLost; });
  if (lost != reference.amplification.end()) {
    const auto k = static_cast<std::size_t>(lost - reference.amplification.begin());
    text << "a disturbance grows a million times by t = " << reference.motion.times[k] << " s";
  } else {
    const double most = std::ranges::max(reference.amplification);
    text << "a small disturbance " << (most > 1 ? "grows " : "shrinks, to at most ") << most << " times";
  }
  return text.str();
}

std::string winners(const WorkChart& chart, double error, Cost cost) {
  std::ostringstream text = stream();
  const std::vector<Price> prices = pricesOf(chart.rows, error, cost);
  constexpr std::size_t kShown = 3;
  for (std::size_t k = 0; k < std::min(kShown, prices.size()); ++k) {
    const Price& price = prices[k];
    text << (k == 0 ? "" : ", ") << price.integrator << (price.precision == Precision::Float ? " in float " : " ");
    if (cost == Cost::Seconds) {
      text << 1000 * price.cost / chart.duration << " ms";
    } else {
      text << std::llround(price.cost / chart.duration);
    }
  }
  return prices.empty() ? "none" : text.str();
}

}  // namespace

std::vector<std::string> chartNotes(const Reference& reference, const std::string& machine, int threads) {
  const Scene& scene = reference.scene;
  std::ostringstream first = stream(), second = stream();
  first << scene.columns << " x " << scene.rows << " particles, " << std::setprecision(6) << scene.duration
        << " s simulated; " << machine << ", " << threads << (threads == 1 ? " thread" : " threads")
        << "; error: RMS distance over all particles from the reference, the largest at "
        << reference.motion.times.size() << " times";
  second << "reference: dopri54 within " << reference.scene.tolerance << " m a step; rk4 in steps of "
         << reference.secondStep << " s agrees to " << reference.disagreement.back() / reference.size
         << " of the size; " << amplificationText(reference);
  return {first.str(), second.str()};
}

std::string cheapestMethods(const WorkChart& chart) {
  std::ostringstream text;
  text << "error/size  cheapest by time (per simulated second); by force evaluations\n";
  for (const double error : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10}) {
    text << std::setw(10) << error << "  " << winners(chart, error * chart.size, Cost::Seconds) << "; "
         << winners(chart, error * chart.size, Cost::Evaluations) << "\n";
  }
  return text.str();
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
  std::ostringstream text = stream();
  for (auto& [method, values] : ratios) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    text << method << ": " << *middle << " times the seconds of before per simulated second (middle of "
         << values.size() << " rows)\n";
  }
  return text.str();
}

std::string sheetLines(const std::vector<SheetDistance>& sheets, double size) {
  std::ostringstream text = stream();
  for (const SheetDistance& sheet : sheets) {
    text << "the same cloth as " << sheet.grid.columns << "x" << sheet.grid.rows << " is " << sheet.distance.rms / size
         << " of the size away (RMS), " << sheet.distance.largest << " m at most\n";
  }
  return text.str();
}

std::string sheetsCsv(const std::vector<SheetDistance>& sheets) {
  std::ostringstream text;
  text << "columns,rows,rms_distance_m,max_distance_m\n" << std::setprecision(17);
  for (const SheetDistance& sheet : sheets) {
    text << sheet.grid.columns << "," << sheet.grid.rows << "," << sheet.distance.rms << "," << sheet.distance.largest
         << "\n";
  }
  return text.str();
}

}  // namespace tyg

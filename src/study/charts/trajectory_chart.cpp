// One column of panels a particle, one row a coordinate that changes, and below them how far each method is from the
// finest one, so that curves which overlap still tell something.
#include "study/charts/trajectory_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "core/scene/bodies.h"
#include "study/charts/chart_script.h"
#include "study/charts/gnuplot.h"

namespace tyg {
namespace {

// In pixels of the PNG, and of the SVG before it is scaled.
constexpr double kSingleWidth = 1600, kWidth = 2360, kNarrowestColumn = 620, kPanelHeight = 270, kGap = 36;
constexpr double kLeft = 190, kRight = 50, kBottom = 140;
constexpr double kHead = 150, kLegendRow = 44, kSampleWidth = 120, kCharacterWidth = 11.5;

constexpr const char* kInk = "#000000";
constexpr std::size_t kMarks = 6;  // along a curve
constexpr double kMarkSize = 2;

constexpr std::array kCoordinates{&Vec3::x, &Vec3::y, &Vec3::z};
constexpr std::array kNames{"x", "y", "z"};

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  [[nodiscard]] bool empty() const { return !(low <= high); }
  [[nodiscard]] Range widened(double fraction) const {
    const double margin = fraction * (high - low);
    return {low - margin, high + margin};
  }
};

/// Where a curve of a coordinate lies: over the runs that held, because one that failed may be anywhere; where none
/// held, within a few sizes of the sheet from the start.
Range rangeOf(const TrajectoryStudy& study, std::size_t particle, double Vec3::*coordinate) {
  const bool anyHeld = std::ranges::any_of(study.runs, [](const Trajectory& run) { return run.status == Status::Ok; });
  const double reach = 3 * makeSheet(study.scene).size();
  Range range;
  for (const Trajectory& run : study.runs) {
    if (anyHeld && run.status != Status::Ok) continue;
    const double start = run.paths[particle].front().*coordinate;
    for (const Vec3& at : run.paths[particle]) {
      if (anyHeld || std::abs(at.*coordinate - start) <= reach) range.include(at.*coordinate);
    }
  }
  return range;
}

/// Positive distances from the finest run; empty where there is nothing to compare.
Range distanceRange(const TrajectoryStudy& study, std::size_t particle) {
  Range range;
  for (std::size_t k = 0; k < study.runs.size(); ++k) {
    if (study.runs[k].status != Status::Ok) continue;
    for (std::size_t i = 0; i < study.runs[k].times.size(); ++i) {
      const double distance = distanceFromFinest(study, k, particle, i);
      if (distance > 0) range.include(distance);
    }
  }
  return range;
}

/// A change of a coordinate that is rounding, m: a hundred units of the numbers' last place, or what the digits of the
/// script leave. Relative to the sheet and to how far it is from the origin.
double roundingOf(const TrajectoryStudy& study) {
  constexpr double kUnits = 100, kDigits = 1e-10;
  const bool isFloat = study.scene.precision == Precision::Float;
  const double unit = isFloat ? std::numeric_limits<float>::epsilon() : std::numeric_limits<double>::epsilon();
  double largest = makeSheet(study.scene).size();
  for (std::size_t p = 0; p < study.particles.size(); ++p) {
    for (const auto coordinate : kCoordinates) {
      const Range range = rangeOf(study, p, coordinate);
      if (!range.empty()) largest = std::max({largest, std::abs(range.low), std::abs(range.high)});
    }
  }
  return std::max(kUnits * unit, kDigits) * largest;
}

/// What a panel shows of a coordinate: its range with some space around it, and a tenth of the sheet where it stays.
Range shownRange(const TrajectoryStudy& study, std::size_t particle, std::size_t coordinate) {
  const Range range = rangeOf(study, particle, kCoordinates.at(coordinate));
  if (range.empty() || range.high - range.low > roundingOf(study)) {
    const bool failed = std::ranges::any_of(study.runs, [](const Trajectory& run) { return run.status != Status::Ok; });
    return range.widened(failed ? 0.3 : 0.08);
  }
  const double middle = (range.low + range.high) / 2, reach = makeSheet(study.scene).size() / 20;
  return {middle - reach, middle + reach};
}

/// Which panels the figure has, and where they are: one row a coordinate that changes, an empty one for the distances.
struct Layout {
  const TrajectoryStudy& study;
  std::vector<std::optional<std::size_t>> rows;
  std::string still;  // the coordinates that do not change, in words
  std::size_t legendColumns = 1;
  double width = 0, height = 0, top = 0;  // pixels

  [[nodiscard]] double columnWidth() const { return width / double(study.particles.size()); }
};

bool changes(const TrajectoryStudy& study, std::size_t coordinate) {
  const double rounding = roundingOf(study);
  for (std::size_t p = 0; p < study.particles.size(); ++p) {
    const Range range = rangeOf(study, p, kCoordinates.at(coordinate));
    if (range.high - range.low > rounding) return true;
  }
  return false;
}

bool anyDistance(const TrajectoryStudy& study) {
  for (std::size_t p = 0; study.runs.size() > 1 && p < study.particles.size(); ++p) {
    if (!distanceRange(study, p).empty()) return true;
  }
  return false;
}

std::string nameOfRun(const Trajectory& run) {
  if (run.status == Status::Ok) return std::string(run.method->label);
  return fmt::format("{} ({} at {:g} s)", run.method->label, nameOf(run.status), run.failedAt);
}

/// How many entries of the legend fit beside each other.
std::size_t legendColumns(const TrajectoryStudy& study, double width) {
  std::size_t longest = 0;
  for (const Trajectory& run : study.runs) longest = std::max(longest, nameOfRun(run).size());
  const double fit = (width - kLeft - kRight) / (kSampleWidth + kCharacterWidth * double(longest));
  return std::clamp<std::size_t>(static_cast<std::size_t>(fit), 1, study.runs.size());
}

Layout layoutOf(const TrajectoryStudy& study) {
  Layout layout{.study = study, .rows = {}, .still = {}};
  for (std::size_t c = 0; c < kCoordinates.size(); ++c) {
    if (changes(study, c)) {
      layout.rows.emplace_back(c);
    } else {
      layout.still.append(layout.still.empty() ? "" : " and ").append(kNames.at(c));
    }
  }
  if (layout.rows.empty()) {  // a cloth at rest: that is what the figure then shows
    layout.rows = {0, 1, 2};
    layout.still.clear();
  }
  if (anyDistance(study)) layout.rows.emplace_back(std::nullopt);
  const bool single = study.particles.size() == 1;
  layout.width = single ? kSingleWidth : std::max(kWidth, kNarrowestColumn * double(study.particles.size()));
  layout.legendColumns = legendColumns(study, layout.width);
  const std::size_t legendRows = (study.runs.size() + layout.legendColumns - 1) / layout.legendColumns;
  layout.top = kHead + kLegendRow * double(legendRows) + (single ? 0 : 40);
  layout.height = layout.top + kBottom + double(layout.rows.size()) * (kPanelHeight + kGap) - kGap;
  return layout;
}

std::string whatIsCharted(const TrajectoryStudy& study) {
  if (study.particles.size() == 1) return fmt::format("the way of the {} particle", study.particles.front().label);
  return fmt::format("the way of {} particles", study.particles.size());
}

std::string subtitleOf(const Layout& layout) {
  const Scene& scene = layout.study.scene;
  std::string text = fmt::format("{} x {} particles, steps of {:g} s", scene.columns, scene.rows, scene.dt);
  const auto isAdaptive = [](const Trajectory& run) { return run.method->adaptive; };
  if (std::ranges::any_of(layout.study.runs, isAdaptive)) {
    text += fmt::format(" (adaptive ones: within {:g} m)", usedTolerance(scene));
  }
  if (layout.still.empty()) return text;
  return fmt::format("{}; {} {} not change", text, layout.still, layout.still.size() > 1 ? "do" : "does");
}

MethodStyle lookOf(const Trajectory& run) { return styleOfMethod(run.method->name); }
std::string colourOf(const Trajectory& run) { return chartColour(lookOf(run).colour); }

/// The finest run is a broad pale band below the others' dashes, so that curves on top of each other all show.
std::string styleOf(std::size_t run, const TrajectoryStudy& study) {
  constexpr std::array kDashes{"(9,5)", "(3,3)", "(9,4,2,4)", "(16,5)"};
  const std::string colour = colourOf(study.runs[run]);
  if (run == study.finest) return fmt::format("lw 9 dt 1 lc rgb '#90{}'", colour.substr(1));
  return fmt::format("lw 4 dt {} lc rgb '{}'", kDashes.at(run % kDashes.size()), colour);
}

/// gnuplot's own key breaks its rows where it likes; this one keeps the order of the methods.
void addLegend(const Layout& layout, ChartScript& script) {
  const TrajectoryStudy& study = layout.study;
  const std::size_t columns = layout.legendColumns;
  const double entryWidth = (layout.width - kLeft - kRight) / double(std::max<std::size_t>(columns, 3));
  for (std::size_t k = 0; k < study.runs.size(); ++k) {
    const Trajectory& run = study.runs[k];
    const std::size_t column = k % columns, row = k / columns;
    const Pixel at{kLeft + entryWidth * double(column), kHead + kLegendRow * double(row)};
    const double y = 1 - at.y / layout.height;
    script.add("  set arrow from screen {:.12g},{:.12g} to screen {:.12g},{:.12g} nohead {}\n", at.x / layout.width, y,
               (at.x + kSampleWidth - 30) / layout.width, y, styleOf(k, study));
    script.point({at.x + (kSampleWidth - 30) / 2, at.y}, gnuplotType(lookOf(run).mark) + 1, kMarkSize, colourOf(run));
    script.label(nameOfRun(run), {at.x + kSampleWidth - 15, at.y}, {.colour = kInk});
  }
}

/// The method's mark, hollow and with a cross in it, where a run that failed was last seen.
void addCrosses(const TrajectoryStudy& study, std::size_t coordinate, std::size_t p, const Range& shown,
                ChartScript& script) {
  for (const Trajectory& run : study.runs) {
    if (run.status == Status::Ok) continue;
    const double last = run.paths[p].back().*kCoordinates.at(coordinate);
    const double height = std::isfinite(last) ? std::clamp(last, shown.low, shown.high) : shown.high;
    constexpr int kCross = 2;
    for (const auto& [type, size] : {std::pair{gnuplotType(lookOf(run).mark), 3.2}, {kCross, 1.6}}) {
      script.add("  set label '' at first {:.12g},{:.12g} point pt {} ps {:g} lw 3 lc rgb '{}' front\n",
                 run.times.back(), height, type, size, colourOf(run));
    }
  }
}

void addCoordinateAxis(const TrajectoryStudy& study, std::size_t coordinate, std::size_t p, ChartScript& script) {
  const Range shown = shownRange(study, p, coordinate);
  script.add("  unset logscale y\n  set format y '%g'\n  set ylabel '{} (m)'\n", kNames.at(coordinate));
  if (shown.high > shown.low) {
    script.add("  set yrange [{:.12g}:{:.12g}]\n", shown.low, shown.high);
  } else {
    script.add("  set yrange [*:*]\n");
  }
  addCrosses(study, coordinate, p, shown, script);
}

void addDistanceAxis(const TrajectoryStudy& study, std::size_t p, ChartScript& script) {
  const Range range = distanceRange(study, p);
  script.add(range.empty() ? "  unset logscale y\n  set format y '%g'\n"
                           : "  set logscale y\n  set format y '10^{%T}'\n");
  script.add("  set ylabel \"distance from\\n{} (m)\"\n", study.runs[study.finest].method->label);
  if (range.empty()) return script.add("  set yrange [-1:1]\n");  // all are the same, and a logarithm shows no 0
  // Whole decades, so that there are labelled tics; curves that cross dip without end and are cut four decades down.
  const double high = std::ceil(std::log10(1.1 * range.high));
  const double low = std::max(std::floor(std::log10(range.low)), high - 4);
  script.add("  set yrange [1e{:g}:1e{:g}]\n", low, high);
}

/// What holds the rows of one particle by one run, of which gnuplot has many panels to draw.
std::string blockOf(std::size_t run, std::size_t p) { return fmt::format("$run{}_{}", run, p); }

/// Reads each curve once: t, x, y, z and distance. They are copied as texts, because numbers would be rounded.
void addBlocks(const TrajectoryStudy& study, ChartScript& script) {
  std::size_t skipped = 1;  // the header
  for (std::size_t k = 0; k < study.runs.size(); ++k) {
    const std::size_t rows = study.runs[k].times.size();
    for (std::size_t p = 0; p < study.particles.size(); ++p, skipped += rows) {
      script.add("set table {}  # {}, {}\n", blockOf(k, p), study.runs[k].method->name, study.particles[p].label);
      script.add(
          "plot 'plot.csv' skip {} every ::0::{} using (strcol(3)):(strcol(4)):(strcol(5)):(strcol(6))"
          ":(strcol(7)) with table\n",
          skipped, rows - 1);
    }
  }
  script.add("unset table\nset datafile separator whitespace\n");
}

/// The finest run first, below all others; then the marks of all, each at other times.
void addCurves(const TrajectoryStudy& study, std::size_t p, int column, ChartScript& script) {
  const auto curve = [&](std::size_t k) {
    script.add("{} using 1:{} with lines {}", blockOf(k, p), column, styleOf(k, study));
  };
  script.add("  plot ");
  curve(study.finest);
  for (std::size_t k = 0; k < study.runs.size(); ++k) {
    if (k == study.finest) continue;
    script.add(", \\\n       ");
    curve(k);
  }
  for (std::size_t k = 0; k < study.runs.size(); ++k) {
    const Trajectory& run = study.runs[k];
    const std::size_t every = std::max<std::size_t>(run.times.size() / kMarks, 1);
    const std::size_t first = every * (2 * k + 1) / (2 * study.runs.size());
    script.add(", \\\n       ");
    script.add("{} every {}::{} using 1:{} with points pt {} ps {:g} lc rgb '{}'", blockOf(k, p), every, first, column,
               gnuplotType(lookOf(run).mark) + 1, kMarkSize, colourOf(run));
  }
  script.add("\n");
}

void addPanel(const Layout& layout, std::size_t row, std::size_t p, ChartScript& script) {
  const TrajectoryStudy& study = layout.study;
  const double left = double(p) * layout.columnWidth() + kLeft;
  const double right = double(p + 1) * layout.columnWidth() - kRight;
  const double top = layout.top + double(row) * (kPanelHeight + kGap);
  script.panel({left, right, top, top + kPanelHeight});
  if (row == 0 && study.particles.size() > 1) {
    script.label(study.particles[p].label, {left, top - 22}, {.colour = kInk});
  }
  script.add(row + 1 == layout.rows.size() ? "  set xlabel 'time (s)'\n  set format x '%g'\n"
                                           : "  unset xlabel\n  set format x ''\n");
  if (row == 0 && p == 0) addLegend(layout, script);
  const std::optional<std::size_t> coordinate = layout.rows[row];
  coordinate ? addCoordinateAxis(study, *coordinate, p, script) : addDistanceAxis(study, p, script);
  constexpr int kFirstCoordinate = 2, kDistance = 5;  // columns of a block
  addCurves(study, p, coordinate ? kFirstCoordinate + static_cast<int>(*coordinate) : kDistance, script);
  script.add("  unset label\n  unset arrow\n");
}

}  // namespace

std::string trajectoryScript(const TrajectoryStudy& study) {
  const Layout layout = layoutOf(study);
  constexpr int kLetters = 22, kDigits = 12;
  ChartScript script(layout.width, layout.height, kLetters, kDigits);
  script.add("# Draws plot.svg and plot.png from plot.csv:  gnuplot plot.gp\nset datafile separator comma\n");
  script.namePictures("plot");
  addBlocks(study, script);
  script.beginPictures();
  script.add("  set grid lt 1 lc '#d0d0d0' lw 1\n  set xrange [0:{:.12g}]\n", study.scene.duration);
  script.title(study.scene.title, whatIsCharted(study), {kLeft, 45});
  script.label(subtitleOf(layout), {kLeft, 95}, {.colour = "#555555"});
  for (std::size_t row = 0; row < layout.rows.size(); ++row) {
    for (std::size_t p = 0; p < study.particles.size(); ++p) addPanel(layout, row, p, script);
  }
  script.endPictures();
  return script.text();
}

}  // namespace tyg

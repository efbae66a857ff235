// Curves are drawn from rows.csv; what gnuplot cannot lay out itself (names at the ends of curves, arrows, bands, the
// legend) gets its position here.
#include "study/charts/work_chart.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "study/charts/chart_script.h"
#include "study/charts/gnuplot.h"
#include "study/charts/method_style.h"
#include "study/charts/work_chart_axes.h"
#include "study/work/past_horizon.h"

namespace tyg {
namespace {

using Side = ChartScript::Side;

constexpr double kArrow = 42, kCharacter = 14.2, kBeside = 225;  // pixels
constexpr const char *kGrey = "#666666", *kInk = "#222222", *kSpatial = "#A03000";
constexpr int kSpatialDash = 2;
constexpr int kCross = 2, kPlus = 1, kDot = 7;  // gnuplot's point types

/// What a method's curve looks like, the same in every chart whichever methods are in it.
struct Style {
  std::string colour;
  int filled = 7, hollow = 6;  ///< gnuplot's point types
  int dash = 1;
};

Style styleOf(const std::string& method) {
  const MethodStyle style = styleOfMethod(method);
  const int hollow = gnuplotType(style.mark);
  return {chartColour(style.colour), hollow + 1, hollow, style.dashed ? 2 : 1};
}

/// The same colour, with this much of what lies behind it showing through (00 to ff).
std::string pale(const std::string& colour, const char* through) {
  return "#" + std::string(through) + colour.substr(1);
}

bool inSeconds(const ChartPanel& panel) { return panel.work == ChartPanel::Work::Seconds; }
bool ofErrors(const ChartPanel& panel) { return panel.shown == ChartPanel::Shown::Error; }

double heightAt(const ChartPanel& panel, double value) { return panel.pixel(1, value).y; }

bool tooSlow(const WorkChart& chart, const std::string& method) {
  return std::ranges::any_of(chart.rows, [&](const WorkRow& row) {
    return row.integrator == method && row.precision == Precision::Double && row.status == RowStatus::TooSlow;
  });
}

/// What the columns of rows.csv mean, as gnuplot's functions.
void addDefinitions(const WorkChart& chart, const ChartPanel& panel, ChartScript& script) {
  script.add("# Draws chart.svg and chart.png from rows.csv:  gnuplot chart.gp\n");
  script.namePictures("chart");
  // All digits: the duration is compared with the horizons of the rows.
  script.add(
      "set datafile separator comma\n"
      "size = {:.17g}       # m, of the sheet\nduration = {:.17g}   # s, simulated in every run\n"
      "most = {:.17g}   # largest error shown, fraction of the size\n"
      "failed = {:.17g}   # where runs that failed are shown\n",
      chart.size, chart.duration, panel.belowStrip(), panel.inStrip());
  script.add(
      "is(method, precision) = strcol(4) eq method && strcol(5) eq precision\n"
      "whole = duration * (1 - 1e-9)\n"
      "error(wanted) = wanted && strcol(16) eq 'ok' && $11 > 0 && $11 / size <= most ? $11 / size : NaN\n"
      "trusted(wanted) = error(wanted && $15 >= whole)\n"
      "past(wanted) = error(wanted && $15 < whole && $11 >= $14)   # its horizon\n"
      "sure(wanted) = error(wanted && $11 >= 10 * $14)\n"
      "below(wanted) = error(wanted && $15 < whole && $11 < $14)   # the floor\n"
      "drift(wanted) = wanted && strcol(16) eq 'ok' && $13 > 0 ? $13 : NaN\n"
      "failure(wanted) = wanted && (strcol(16) eq 'unstable' || strcol(16) eq 'not-finite') ? failed : NaN\n"
      "simulated(all) = strcol(16) eq 'ok' ? all : $8 * $6\n");
}

/// The title and the smaller lines below it.
void addHead(const WorkChart& chart, ChartScript& script) {
  script.title(chart.scene, "speed against accuracy", {60, 50});
  for (std::size_t k = 0; k < chart.notes.size(); ++k) {
    script.label(chart.notes[k], {60, 62 + 38 * double(k + 1)}, {.colour = kGrey});
  }
}

/// Right of the lower panel, one line below the other.
void addLegend(const WorkChart& chart, double left, ChartScript& script) {
  Pixel at{left, ChartCanvas::kLowerTop};
  const auto line = [&](const std::string& words) {
    script.label(words, {at.x + 50, at.y}, {.colour = kInk, .scale = 0.9});
    at.y += 37;
  };
  const auto entry = [&](int type, double size, const char* colour, const std::string& words) {
    script.point({at.x + 20, at.y}, type, size, colour);
    line(words);
  };
  entry(kDot, 2.2, kInk, "double");
  entry(6, 2.0, kInk, "float");
  entry(kDot, 0.9, "#888888", "past its horizon T*: rounding has come within a tenth of the error");
  const std::vector<std::string> horizons = horizonLines(chart.rows, chart.duration);
  for (const std::string& words : horizons) line("    " + words);
  if (!horizons.empty()) line("    past T* compare the energy's drift, below left, and past_horizon.csv");
  entry(kPlus, 1.5, "#888888", "below the floor, rounding dominates");
  script.point({at.x + 20, at.y}, kCross, 1.3, kInk);
  entry(6, 2.6, kInk, "failed");
  script.line(at, {at.x + 40, at.y}, {.colour = kInk, .width = 2.5, .head = true});
  line(fmt::format("finer steps take over {:g} s a run", chart.runBudget));
  if (chart.spatial) {
    script.line(at, {at.x + 40, at.y}, {.colour = kSpatial, .dash = kSpatialDash});
    line(fmt::format("as {}x{} this cloth is this far away: smaller errors are not seen", chart.spatial->columns,
                     chart.spatial->rows));
  }
  if (chart.comparedDuration) entry(kDot, 1.4, "#b0b0b0", "the file compared with");
  const auto withoutForces = std::ranges::find_if(
      chart.rows, [](const WorkRow& row) { return row.status == RowStatus::Ok && row.forceEvaluations == 0; });
  if (withoutForces != chart.rows.end()) {
    line(withoutForces->integrator + " computes no forces: it is not in the right panel");
  }
}

void addAxes(const ChartPanel& panel, ChartScript& script) {
  script.panel({panel.left, panel.right, panel.top, panel.bottom});
  script.add("  set xrange [{:g}:{:g}]\n  set yrange [{:g}:{:g}]\n", panel.x.low, panel.x.high, panel.y.low,
             panel.y.high);
  script.add("  set xlabel '{}' offset 0,-0.3\n  set ylabel '{}' offset 0.5,0\n",
             inSeconds(panel) ? "seconds of computing per simulated second" : "force evaluations per simulated second",
             !inSeconds(panel) ? ""
             : ofErrors(panel) ? "error / size of the sheet"
                               : "drift of the energy / its scale");
}

void addBands(const WorkChart& chart, const ChartPanel& panel, ChartScript& script) {
  script.area({panel.left, panel.right, panel.top, panel.top + panel.strip}, "#f3e3e3");
  const double floor = heightAt(panel, chart.floorOfDouble / chart.size);
  if (floor < panel.bottom) {
    script.area({panel.left, panel.right, std::max(floor, panel.top + panel.strip), panel.bottom}, "#dcdcdc");
  }
}

/// Lines that fall as fast as errors of order 1, 2 and 4 do, in the lower left corner.
void addSlopes(const WorkChart& chart, const ChartPanel& panel, ChartScript& script) {
  const double width = panel.right - panel.left, height = panel.bottom - panel.top;
  const double xDecade = width / std::log10(panel.x.high / panel.x.low);
  const double yDecade = height / std::log10(panel.y.high / panel.y.low);
  const double clear = std::min(panel.bottom - 45, heightAt(panel, chart.floorOfDouble / chart.size) - 75);
  const Pixel start{panel.left + 0.05 * width, std::min(panel.bottom - 0.2 * height, clear - yDecade)};
  for (const int order : {1, 2, 4}) {
    const Pixel end{start.x + xDecade / order, start.y + yDecade};
    script.line(start, end, {.colour = kGrey});
    script.label(std::to_string(order), {end.x, end.y + 21}, {.colour = kGrey, .scale = 0.9, .side = Side::Centre});
  }
  script.label("order", {start.x, start.y - 19}, {.colour = kGrey, .scale = 0.9});
}

/// Horizontal lines: the floors, and a finer sheet's distance.
void addLevels(const WorkChart& chart, const ChartPanel& panel, ChartScript& script) {
  const auto level = [&](double value, const std::string& words, const char* colour, int dash) {
    const double y = heightAt(panel, value / chart.size);
    if (!(y > panel.top + panel.strip && y < panel.bottom)) return;
    script.line({panel.left, y}, {panel.right, y}, {.colour = colour, .dash = dash});
    script.label(words, {panel.left + 11, y - 16}, {.colour = colour, .scale = 0.8});
  };
  const bool first = inSeconds(panel);
  level(chart.floorOfFloat, first ? "floor of float" : "", kGrey, 3);
  level(chart.floorOfDouble, first ? "floor of double" : "", kGrey, 3);
  if (chart.spatial) level(chart.spatial->distance, "", kSpatial, kSpatialDash);  // the legend says what it is
}

/// Methods without a curve are named beside the strip of failures, one below the other.
std::vector<std::string> withoutCurve(const WorkChart& chart) {
  std::vector<std::string> names;
  for (const std::string& method : chartedMethods(chart)) {
    const bool any = std::ranges::any_of(
        chart.rows, [&](const WorkRow& row) { return row.integrator == method && row.status == RowStatus::Ok; });
    if (!any) names.push_back(method);
  }
  return names;
}
constexpr double kFailedHeight = 32;

void addFailedOnes(const WorkChart& chart, const ChartPanel& panel, ChartScript& script) {
  script.label("failed:", {panel.left, panel.top - 18}, {.colour = kGrey, .scale = 0.8});
  Pixel at{panel.right + 10, panel.top + panel.strip / 2};
  for (const std::string& method : withoutCurve(chart)) {
    script.label((tooSlow(chart, method) ? "\u2192 " : "\u00d7 ") + method, at,
                 {.colour = styleOf(method).colour, .scale = 0.95});
    at.y += kFailedHeight;
  }
}

void addRealTime(const ChartPanel& panel, ChartScript& script) {
  const double fraction = panel.x.fractionAt(1);
  if (!(fraction > 0 && fraction < 1)) return;
  const double x = panel.pixel(1, 1).x;
  script.line({x, panel.bottom}, {x, panel.top + panel.strip}, {.colour = kInk, .width = 2.5, .dash = 4});
  if (!ofErrors(panel)) return;
  script.label("real time: 16.7 ms for a frame of 60 Hz", {x - 18, panel.bottom - 19},
               {.colour = kInk, .scale = 0.8, .upward = true});
}

/// What names must keep clear of: boxes that are taken, and as far as possible lines.
struct InTheWay {
  std::vector<PixelBox> boxes;
  std::vector<std::vector<Pixel>> lines;
};

InTheWay inTheWay(const WorkChart& chart, const ChartPanel& panel) {
  InTheWay found;
  if (inSeconds(panel)) {
    const double x = panel.pixel(1, 1).x;  // the line of real time and its text
    found.lines.push_back({{x, panel.top}, {x, panel.bottom}});
    if (ofErrors(panel)) found.boxes.push_back({x - 34, x + 4, panel.bottom - 410, panel.bottom});
  }
  for (const std::string& method : chartedMethods(chart)) {
    for (const Precision precision : {Precision::Double, Precision::Float}) {
      found.lines.push_back(curveOf(chart, panel, method, precision));
    }
  }
  if (!ofErrors(panel)) return found;
  found.boxes.push_back({panel.right, panel.right + kBeside, panel.top,
                         panel.top + panel.strip / 2 + kFailedHeight * double(withoutCurve(chart).size())});
  std::vector<double> levels{chart.floorOfFloat, chart.floorOfDouble};
  if (chart.spatial) levels.push_back(chart.spatial->distance);
  for (const double at : levels) {
    const double y = heightAt(panel, at / chart.size);
    found.lines.push_back({{panel.left, y}, {panel.right, y}});
  }
  return found;
}

void addName(const PixelBox& box, const Pixel& end, const std::string& method, double scale, ChartScript& script) {
  const std::string colour = styleOf(method).colour;
  const double centre = (box.top + box.bottom) / 2;
  script.label(method, {box.left, centre}, {.colour = colour, .scale = scale});
  if (const auto tip = leaderTo(box, end)) script.line(end, *tip, {.colour = pale(colour, "60"), .width = 1.2});
}

/// A method's name at the end of its curve, and an arrow there where finer steps would take too long.
void addNames(const WorkChart& chart, const ChartPanel& panel, ChartScript& script) {
  const double scale = ofErrors(panel) ? 1 : 0.8;
  std::vector<std::string> shown;
  std::vector<WantedLabel> wanted;
  InTheWay avoided = inTheWay(chart, panel);
  for (const std::string& method : chartedMethods(chart)) {
    const WorkRow* end = endOfCurve(chart, panel, method);
    if (end == nullptr) continue;
    Pixel at = panel.pixel(panel.workOf(*end, chart.duration), panel.heightOf(*end, chart.size));
    if (ofErrors(panel) && tooSlow(chart, method)) {
      const Pixel last = curveOf(chart, panel, method, end->precision).back(), tip{last.x + kArrow, last.y};
      script.line(last, tip, {.colour = styleOf(method).colour, .width = 2.5, .head = true, .front = true});
      avoided.lines.push_back({last, tip});
      at.x += kArrow - 10;
    }
    shown.push_back(method);
    wanted.push_back({at, scale * kCharacter * double(method.size()), scale * 34});
  }
  const PixelBox bounds{panel.left + 5, panel.right + kBeside, panel.top + panel.strip + 12, panel.bottom};
  const std::vector<PixelBox> boxes = placeLabels(wanted, avoided.lines, avoided.boxes, bounds);
  for (std::size_t k = 0; k < shown.size(); ++k) addName(boxes[k], wanted[k].at, shown[k], scale, script);
}

constexpr std::array kPrecisions{Precision::Float, Precision::Double};  // double is drawn above float

void addCurve(const ChartPanel& panel, const std::string& method, Precision precision, ChartScript& script) {
  const Style style = styleOf(method);
  const bool isDouble = precision == Precision::Double;
  const auto plot = [&](const char* y, const std::string& with) {
    script.add(", \\\n       'rows.csv' skip 1 using (${} / simulated(duration)):({}(is({},'{}'))) with {}",
               inSeconds(panel) ? 10 : 9, y, gnuplotQuoted(method), nameOf(precision), with);
  };
  const std::string colour = fmt::format("lc rgb '{}'", isDouble ? style.colour : pale(style.colour, "50"));
  const std::string points = isDouble ? fmt::format("points pt {} ps 2.1 {}", style.filled, colour)
                                      : fmt::format("points pt {} ps 1.6 lw 1.6 {}", style.hollow, colour);
  plot(ofErrors(panel) ? "error" : "drift",
       fmt::format("lines {} dt {} {}", isDouble ? "lw 3.5" : "lw 1.6", style.dash, colour));
  if (!ofErrors(panel)) return plot("drift", points);
  const std::string doubtful = pale(style.colour, isDouble ? "20" : "50");
  plot("past", fmt::format("points pt {} ps 0.9 lc rgb '{}'", kDot, doubtful));
  plot("below", fmt::format("points pt {} ps 1.5 lw 2 lc rgb '{}'", kPlus, doubtful));
  plot("trusted", points);
  plot("failure",
       fmt::format("points pt {} {} {}", style.hollow, isDouble ? "ps 2.6 lw 2.5" : "ps 1.8 lw 1.6", colour));
  plot("failure", fmt::format("points pt {} {} {}", kCross, isDouble ? "ps 1.3 lw 2.5" : "ps 0.9 lw 1.6", colour));
}

/// The curves of the file compared with, wide and grey below all others.
void addEarlier(const ChartPanel& panel, const std::string& method, double duration, ChartScript& script) {
  for (const Precision precision : kPrecisions) {
    const auto plot = [&](const char* y, const char* with) {
      script.add(", \\\n       'compare.csv' skip 1 using (${} / {:g}):({}(is({},'{}'))) with {} lc rgb '#c8c8c8'",
                 inSeconds(panel) ? 10 : 9, duration, y, gnuplotQuoted(method), nameOf(precision), with);
    };
    plot(ofErrors(panel) ? "error" : "drift", "lines lw 7");
    plot(ofErrors(panel) ? "sure" : "drift", "points pt 7 ps 1.2");
  }
}

void addPanel(const WorkChart& chart, const ChartPanel& panel, ChartScript& script) {
  addAxes(panel, script);
  if (ofErrors(panel)) {
    addBands(chart, panel, script);
    addSlopes(chart, panel, script);
    addLevels(chart, panel, script);
    addFailedOnes(chart, panel, script);
  }
  if (inSeconds(panel)) addRealTime(panel, script);
  addNames(chart, panel, script);
  const std::vector<std::string> methods = chartedMethods(chart);
  script.add("  plot NaN notitle");
  for (const std::string& method : methods) {
    if (chart.comparedDuration) addEarlier(panel, method, *chart.comparedDuration, script);
  }
  for (const std::string& method : methods) {
    for (const Precision precision : kPrecisions) addCurve(panel, method, precision, script);
  }
  script.add("\n  unset label\n  unset arrow\n  unset object\n");
}

}  // namespace

std::string workChartScript(const WorkChart& chart) {
  const std::vector<ChartPanel> panels = chartPanels(chart);
  ChartScript script(ChartCanvas::kWidth, ChartCanvas::kHeight);
  addDefinitions(chart, panels[0], script);
  script.beginPictures();
  script.add("  set grid lt 1 lc '#dddddd' lw 1\n  set logscale xy\n  set format xy '10^{%T}'\n");
  addHead(chart, script);
  addLegend(chart, panels[1].left - 60, script);
  for (const ChartPanel& panel : panels) addPanel(chart, panel, script);
  script.endPictures();
  return script.text();
}

}  // namespace tyg

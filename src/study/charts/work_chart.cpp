// The gnuplot script of the chart. Curves are drawn from rows.csv; what gnuplot cannot lay out itself (names at the
// ends of curves, arrows, bands, the legend) is placed here.
#include "study/charts/work_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "study/charts/chart_pen.h"
#include "study/charts/gnuplot.h"
#include "study/charts/method_look.h"
#include "study/charts/work_chart_axes.h"
#include "study/motion/past_horizon.h"

namespace tyg {
namespace {

using Side = ChartPen::Side;

constexpr double kArrow = 42, kCharacter = 14.2, kBeside = 225;  // pixels
constexpr const char *kGrey = "#666666", *kInk = "#222222", *kSpatial = "#A03000";
constexpr int kCross = 2, kPlus = 1, kDot = 7;  // gnuplot's point types

/// A method's look, the same in every chart whichever methods are in it.
struct Look {
  std::string colour;
  int filled = 7, hollow = 6;  ///< gnuplot's point types
  int dash = 1;
};

Look lookOf(const std::string& method) {
  constexpr std::array kHollow{8, 6, 4, 10, 12, 14};  // in the order of Mark
  const MethodLook look = lookOfMethod(method);
  const int hollow = kHollow.at(static_cast<std::size_t>(look.mark));
  return {chartColour(look.colour), hollow + 1, hollow, look.dashed ? 2 : 1};
}

/// The same colour, with this much of what lies behind it showing through (00 to ff).
std::string pale(const std::string& colour, const char* through) {
  return "#" + std::string(through) + colour.substr(1);
}

bool inSeconds(const ChartPanel& panel) { return panel.work == ChartPanel::Work::Seconds; }
bool ofErrors(const ChartPanel& panel) { return panel.shown == ChartPanel::Shown::Error; }

class Script {
 public:
  explicit Script(const WorkChart& chart)
      : chart_(chart), panels_(chartPanels(chart)), methods_(chartedMethods(chart)) {}

  std::string text() {
    definitions();
    terminals();
    for (std::size_t k = 0; k < chart_.notes.size() + 1; ++k) note(k);
    legend();
    for (const ChartPanel& panel : panels_) draw(panel);
    endPictures(out_);
    return out_.str();
  }

 private:
  void definitions() {
    const auto digits = out_.precision(17);  // the duration is compared with the horizons of the rows
    out_ << "# Draws chart.svg and chart.png from rows.csv:  gnuplot chart.gp\n";
    namePictures(out_, "chart");
    out_ << "set datafile separator comma\n"
         << "size = " << chart_.size << "       # m, of the sheet\nduration = " << chart_.duration
         << "   # s, simulated in every run\n"
         << "most = " << panels_[0].belowStrip() << "   # largest error shown, fraction of the size\n"
         << "failed = " << panels_[0].inStrip() << "   # where runs that failed are shown\n"
         << "is(method, precision) = strcol(4) eq method && strcol(5) eq precision\n"
            "whole = duration * (1 - 1e-9)\n"
            "error(wanted) = wanted && strcol(16) eq 'ok' && $11 > 0 && $11 / size <= most ? $11 / size : NaN\n"
            "trusted(wanted) = error(wanted && $15 >= whole)\n"
            "past(wanted) = error(wanted && $15 < whole && $11 >= $14)   # its horizon\n"
            "sure(wanted) = error(wanted && $11 >= 10 * $14)\n"
            "below(wanted) = error(wanted && $15 < whole && $11 < $14)   # the floor\n"
            "drift(wanted) = wanted && strcol(16) eq 'ok' && $13 > 0 ? $13 : NaN\n"
            "failure(wanted) = wanted && (strcol(16) eq 'unstable' || strcol(16) eq 'not-finite') ? failed : NaN\n"
            "simulated(all) = strcol(16) eq 'ok' ? all : $8 * $6\n";
    out_.precision(digits);
  }

  void terminals() {
    beginPictures(out_, ChartCanvas::kWidth, ChartCanvas::kHeight);
    out_ << "  set grid lt 1 lc '#dddddd' lw 1\n  set logscale xy\n  set format xy '10^{%T}'\n";
  }

  /// The title and the smaller lines below it.
  void note(std::size_t k) {
    if (k == 0) return pen_.text(chart_.title, {60, 50}, {.colour = kInk, .scale = 1.4});
    pen_.text(chart_.notes[k - 1], {60, 62 + 38 * double(k)}, {.colour = kGrey});
  }

  /// Right of the lower panel, one line below the other.
  void legend() {
    Pixel at{panels_[1].left - 60, ChartCanvas::kLowerTop};
    const auto line = [&](const std::string& words) {
      pen_.text(words, {at.x + 50, at.y}, {.colour = kInk, .scale = 0.9});
      at.y += 37;
    };
    const auto entry = [&](int type, double size, const char* colour, const std::string& words) {
      pen_.point({at.x + 20, at.y}, type, size, colour);
      line(words);
    };
    entry(kDot, 2.2, kInk, "double");
    entry(6, 2.0, kInk, "float");
    entry(kDot, 0.9, "#888888", "past its horizon T*: rounding has come within a tenth of the error");
    const std::vector<std::string> horizons = horizonLines(chart_.rows, chart_.duration);
    for (const std::string& words : horizons) line("    " + words);
    if (!horizons.empty()) line("    past T* compare the energy's drift, below left, and past_horizon.csv");
    entry(kPlus, 1.5, "#888888", "below the floor: may be rounding, not the method");
    entry(kCross, 2.0, kInk, "failed");
    std::ostringstream budget;
    budget << "finer steps take over " << chart_.runBudget << " s a run";
    pen_.line(at, {at.x + 40, at.y}, {.colour = kInk, .width = 2.5, .head = true});
    line(budget.str());
    if (chart_.comparedDuration) entry(kDot, 1.4, "#b0b0b0", "the file compared with");
    const auto withoutForces = std::ranges::find_if(
        chart_.rows, [](const WorkRow& row) { return row.status == RowStatus::Ok && row.forceEvaluations == 0; });
    if (withoutForces != chart_.rows.end()) {
      line(withoutForces->integrator + " computes no forces: it is not in the right panel");
    }
  }

  void draw(const ChartPanel& panel) {
    constexpr double kWidth = ChartCanvas::kWidth, kHeight = ChartCanvas::kHeight;
    out_ << "  set lmargin at screen " << panel.left / kWidth << "\n  set rmargin at screen " << panel.right / kWidth
         << "\n  set tmargin at screen " << 1 - panel.top / kHeight << "\n  set bmargin at screen "
         << 1 - panel.bottom / kHeight << "\n  set xrange [" << panel.x.low << ":" << panel.x.high
         << "]\n  set yrange [" << panel.y.low << ":" << panel.y.high << "]\n  set xlabel '"
         << (inSeconds(panel) ? "seconds of computing per simulated second" : "force evaluations per simulated second")
         << "' offset 0,-0.3\n  set ylabel '"
         << (!inSeconds(panel) ? ""
             : ofErrors(panel) ? "error / size of the sheet"
                               : "drift of the energy / its scale")
         << "' offset 0.5,0\n";
    if (ofErrors(panel)) {
      bands(panel);
      slopes(panel);
      levels(panel);
      failedOnes(panel);
    }
    if (inSeconds(panel)) realTime(panel);
    names(panel);
    curves(panel);
    out_ << "  unset label\n  unset arrow\n  unset object\n";
  }

  [[nodiscard]] static double heightAt(const ChartPanel& panel, double value) { return panel.pixel(1, value).y; }

  void bands(const ChartPanel& panel) {
    pen_.area({panel.left, panel.right, panel.top, panel.top + panel.strip}, "#f3e3e3");
    const double floor = heightAt(panel, chart_.floorOfDouble / chart_.size);
    if (floor < panel.bottom) {
      pen_.area({panel.left, panel.right, std::max(floor, panel.top + panel.strip), panel.bottom}, "#dcdcdc");
    }
  }

  /// Horizontal lines: the floors, and a finer sheet's distance.
  void levels(const ChartPanel& panel) {
    const auto level = [&](double value, const std::string& words, const char* colour, int dash, Side side) {
      const double y = heightAt(panel, value / chart_.size);
      if (!(y > panel.top + panel.strip && y < panel.bottom)) return;
      pen_.line({panel.left, y}, {panel.right, y}, {.colour = colour, .dash = dash});
      pen_.text(words, {side == Side::Left ? panel.left + 11 : panel.right, y - 16},
                {.colour = colour, .scale = 0.8, .side = side});
    };
    const bool first = inSeconds(panel);
    level(chart_.floorOfFloat, first ? "floor of float" : "", kGrey, 3, Side::Left);
    level(chart_.floorOfDouble, first ? "floor of double" : "", kGrey, 3, Side::Left);
    if (!chart_.spatial) return;
    const std::string grid = std::to_string(chart_.spatial->columns) + "x" + std::to_string(chart_.spatial->rows);
    // At the right end of the right panel, where curves of force evaluations are seldom.
    level(chart_.spatial->distance,
          first ? "" : "as " + grid + " this cloth is this far away: smaller errors are not seen", kSpatial, 2,
          Side::Right);
  }

  void realTime(const ChartPanel& panel) {
    if (!(panel.x.place(1) > 0 && panel.x.place(1) < 1)) return;
    const double x = panel.pixel(1, 1).x;
    pen_.line({x, panel.bottom}, {x, panel.top + panel.strip}, {.colour = kInk, .width = 2.5, .dash = 4});
    if (!ofErrors(panel)) return;
    pen_.text("real time: 16.7 ms for a frame of 60 Hz", {x - 18, panel.bottom - 19},
              {.colour = kInk, .scale = 0.8, .upward = true});
  }

  /// Lines that fall as fast as errors of order 1, 2 and 4 do, in the lower left corner.
  void slopes(const ChartPanel& panel) {
    const double width = panel.right - panel.left, height = panel.bottom - panel.top;
    const double xDecade = width / std::log10(panel.x.high / panel.x.low);
    const double yDecade = height / std::log10(panel.y.high / panel.y.low);
    const double clear = std::min(panel.bottom - 45, heightAt(panel, chart_.floorOfDouble / chart_.size) - 75);
    const Pixel start{panel.left + 0.05 * width, std::min(panel.bottom - 0.2 * height, clear - yDecade)};
    for (const int order : {1, 2, 4}) {
      const Pixel end{start.x + xDecade / order, start.y + yDecade};
      pen_.line(start, end, {.colour = kGrey});
      pen_.text(std::to_string(order), {end.x, end.y + 21}, {.colour = kGrey, .scale = 0.9, .side = Side::Centre});
    }
    pen_.text("order", {start.x, start.y - 19}, {.colour = kGrey, .scale = 0.9});
  }

  /// Methods without a curve are named beside the strip of failures, one below the other.
  [[nodiscard]] std::vector<std::string> withoutCurve() const {
    std::vector<std::string> names;
    for (const std::string& method : methods_) {
      const bool any = std::ranges::any_of(
          chart_.rows, [&](const WorkRow& row) { return row.integrator == method && row.status == RowStatus::Ok; });
      if (!any) names.push_back(method);
    }
    return names;
  }
  static constexpr double kFailedHeight = 32;

  void failedOnes(const ChartPanel& panel) {
    pen_.text("failed:", {panel.left, panel.top - 18}, {.colour = kGrey, .scale = 0.8});
    Pixel at{panel.right + 10, panel.top + panel.strip / 2};
    for (const std::string& method : withoutCurve()) {
      pen_.text((tooSlow(method) ? "\u2192 " : "\u00d7 ") + method, at,
                {.colour = lookOf(method).colour, .scale = 0.95});
      at.y += kFailedHeight;
    }
  }

  /// What names must keep clear of: places that are taken, and as far as possible lines.
  struct InTheWay {
    std::vector<PixelBox> boxes;
    std::vector<std::vector<Pixel>> lines;
  };

  [[nodiscard]] InTheWay inTheWay(const ChartPanel& panel) const {
    InTheWay found;
    if (inSeconds(panel)) {
      const double x = panel.pixel(1, 1).x;  // the line of real time and its text
      found.lines.push_back({{x, panel.top}, {x, panel.bottom}});
      if (ofErrors(panel)) found.boxes.push_back({x - 34, x + 4, panel.bottom - 410, panel.bottom});
    }
    if (!ofErrors(panel)) return found;
    found.boxes.push_back({panel.right, panel.right + kBeside, panel.top,
                           panel.top + panel.strip / 2 + kFailedHeight * double(withoutCurve().size())});
    std::vector<double> levels{chart_.floorOfFloat, chart_.floorOfDouble};
    if (chart_.spatial) levels.push_back(chart_.spatial->distance);
    for (const double at : levels) {
      const double y = heightAt(panel, at / chart_.size);
      found.lines.push_back({{panel.left, y}, {panel.right, y}});
    }
    if (chart_.spatial && !inSeconds(panel)) {
      const double y = heightAt(panel, chart_.spatial->distance / chart_.size);
      found.boxes.push_back({panel.right - 660, panel.right, y - 34, y + 2});
    }
    return found;
  }

  /// A method's name at the end of its curve.
  void names(const ChartPanel& panel) {
    const double scale = ofErrors(panel) ? 1 : 0.8;
    std::vector<std::string> shown;
    std::vector<WantedLabel> wanted;
    InTheWay inTheWayOf = inTheWay(panel);
    for (const std::string& method : methods_) {
      for (const Precision precision : {Precision::Double, Precision::Float}) {
        inTheWayOf.lines.push_back(curveOf(chart_, panel, method, precision));
      }
      const WorkRow* end = endOfCurve(chart_, panel, method);
      if (end == nullptr) continue;
      const Pixel at = panel.pixel(panel.workOf(*end, chart_.duration), panel.heightOf(*end, chart_.size));
      const bool arrow = ofErrors(panel) && tooSlow(method);
      if (arrow) {
        const Pixel last = curveOf(chart_, panel, method, end->precision).back(), tip{last.x + kArrow, last.y};
        pen_.line(last, tip, {.colour = lookOf(method).colour, .width = 2.5, .head = true, .front = true});
        inTheWayOf.lines.push_back({last, tip});
      }
      shown.push_back(method);
      wanted.push_back(
          {{at.x + (arrow ? kArrow - 10 : 0), at.y}, scale * kCharacter * double(method.size()), scale * 34});
    }
    const double lowest = ofErrors(panel) ? panel.bottom - 5 : panel.bottom + 20;
    const PixelBox bounds{panel.left, panel.right + kBeside, panel.top + panel.strip + 12, lowest};
    const std::vector<PixelBox> boxes = placeLabels(wanted, inTheWayOf.lines, inTheWayOf.boxes, bounds);
    for (std::size_t k = 0; k < shown.size(); ++k) nameAt(boxes[k], wanted[k].at, shown[k], scale);
  }

  void nameAt(const PixelBox& box, const Pixel& end, const std::string& method, double scale) {
    const std::string colour = lookOf(method).colour;
    const double centre = (box.top + box.bottom) / 2;
    pen_.text(method, {box.left, centre}, {.colour = colour, .scale = scale});
    const double near = std::clamp(end.x, box.left - 6, box.right + 6);
    if (std::hypot(near - end.x, centre - end.y) <= 45) return;
    const double y = near == end.x ? (centre < end.y ? box.bottom : box.top) : centre;
    pen_.line(end, {near, y}, {.colour = pale(colour, "60"), .width = 1.2});
  }

  [[nodiscard]] bool tooSlow(const std::string& method) const {
    return std::ranges::any_of(chart_.rows, [&](const WorkRow& row) {
      return row.integrator == method && row.precision == Precision::Double && row.status == RowStatus::TooSlow;
    });
  }

  void curves(const ChartPanel& panel) {
    out_ << "  plot NaN notitle";
    if (chart_.comparedDuration) earlier(panel);
    for (const std::string& method : methods_) {
      for (const char* precision : {"float", "double"}) curve(panel, method, precision);
    }
    out_ << "\n";
  }

  void curve(const ChartPanel& panel, const std::string& method, const std::string& precision) {
    const Look look = lookOf(method);
    const bool isDouble = precision == "double";
    const std::string wanted = "(is(" + gnuplotQuoted(method) + ",'" + precision + "'))";
    const std::string x = std::string("($") + (inSeconds(panel) ? "10" : "9") + " / simulated(duration))";
    const auto plot = [&](const std::string& y, const std::string& with) {
      out_ << ", \\\n       'rows.csv' skip 1 using " << x << ":(" << y << wanted << ") with " << with;
    };
    const std::string colour = "lc rgb '" + (isDouble ? look.colour : pale(look.colour, "50")) + "'";
    const std::string points = isDouble ? "points pt " + std::to_string(look.filled) + " ps 2.1 " + colour
                                        : "points pt " + std::to_string(look.hollow) + " ps 1.6 lw 1.6 " + colour;
    plot(ofErrors(panel) ? "error" : "drift",
         "lines " + std::string(isDouble ? "lw 3.5" : "lw 1.6") + " dt " + std::to_string(look.dash) + " " + colour);
    if (!ofErrors(panel)) return plot("drift", points);
    const std::string doubtful = " lc rgb '" + pale(look.colour, isDouble ? "20" : "50") + "'";
    plot("past", "points pt " + std::to_string(kDot) + " ps 0.9" + doubtful);
    plot("below", "points pt " + std::to_string(kPlus) + " ps 1.5 lw 2" + doubtful);
    plot("trusted", points);
    plot("failure", std::string("points pt 2 ") + (isDouble ? "ps 2.2 lw 3 " : "ps 1.3 lw 1.6 ") + colour);
  }

  void earlier(const ChartPanel& panel) {
    for (const std::string& method : methods_) {
      for (const char* precision : {"float", "double"}) {
        const auto plot = [&](const char* y, const char* with) {
          out_ << ", \\\n       'compare.csv' skip 1 using ($" << (inSeconds(panel) ? 10 : 9) << " / "
               << *chart_.comparedDuration << "):(" << y << "(is(" << gnuplotQuoted(method) << ",'" << precision
               << "'))) with " << with << " lc rgb '#c8c8c8'";
        };
        plot(ofErrors(panel) ? "error" : "drift", "lines lw 7");
        plot(ofErrors(panel) ? "sure" : "drift", "points pt 7 ps 1.2");
      }
    }
  }

  const WorkChart& chart_;
  std::vector<ChartPanel> panels_;
  std::vector<std::string> methods_;
  std::ostringstream out_;
  ChartPen pen_{out_, ChartCanvas::kWidth, ChartCanvas::kHeight};
};

}  // namespace

std::string workChartScript(const WorkChart& chart) { return Script(chart).text(); }

}  // namespace tyg

// The gnuplot script of the chart. Curves are drawn from rows.csv; what gnuplot cannot lay out itself (labels at the
// ends of curves, arrows, bands) is placed here.
#include "study/work_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "study/gnuplot.h"
#include "study/work_chart_axes.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

constexpr double kWidth = ChartCanvas::kWidth, kHeight = ChartCanvas::kHeight;
constexpr double kArrow = 42, kCharacter = 14.2, kBeside = 170;  // pixels
constexpr const char *kGrey = "#666666", *kInk = "#222222", *kSpatial = "#A03000";

double screenX(double pixels) { return pixels / kWidth; }
double screenY(double pixels) { return 1 - pixels / kHeight; }

/// A method's look, the same in every chart whichever methods are in it.
struct Look {
  std::string colour;
  int filled = 7, hollow = 6;  ///< gnuplot's point types
  int dash = 1;
};

Look lookOf(const std::string& method) {
  constexpr std::array kHollow{8, 6, 4, 10, 12, 14};
  constexpr std::size_t kColours = 7;
  const auto names = methodNames();
  const auto k = static_cast<std::size_t>(std::ranges::find(names, method) - names.begin());
  const int hollow = kHollow.at(k % kHollow.size());
  return {chartColour(k), hollow + 1, hollow, k < kColours ? 1 : 2};
}

/// The same colour, with this much of what lies behind it showing through (00 to ff).
std::string pale(const std::string& colour, const char* through) {
  return "#" + std::string(through) + colour.substr(1);
}

class Script {
 public:
  explicit Script(const WorkChart& chart)
      : chart_(chart), panels_(chartPanels(chart)), error_(errorAxis(chart)), methods_(chartedMethods(chart)) {}

  std::string text() {
    head();
    for (const ChartPanel& panel : panels_) draw(panel);
    out_ << "  unset multiplot\n  unset output\n}\n";
    return out_.str();
  }

 private:
  void head() {
    out_ << "# Draws chart.svg and chart.png from rows.csv:  gnuplot chart.gp\n"
            "if (!exists('svg')) svg = 'chart.svg'\n"
            "if (!exists('png')) png = 'chart.png'\n"
            "set datafile separator comma\n"
         << "size = " << chart_.size << "       # m, of the sheet\nduration = " << chart_.duration
         << "   # s, simulated in every run\n"
         << "failed = " << error_.failures() << "   # where runs that failed are shown\n"
         << "is(method, precision) = strcol(4) eq method && strcol(5) eq precision\n"
            "error(wanted) = wanted && strcol(16) eq 'ok' && $11 > 0 ? $11 / size : NaN\n"
            "trusted(wanted) = error(wanted && $15 >= duration * (1 - 1e-9))\n"
            "doubtful(wanted) = error(wanted && $15 < duration * (1 - 1e-9))\n"
            "failure(wanted) = wanted && (strcol(16) eq 'unstable' || strcol(16) eq 'not-finite') ? failed : NaN\n"
            "simulated(whole) = strcol(16) eq 'ok' ? whole : $8 * $6\n"
            "do for [kind in 'svg png'] {\n"
         << "  if (kind eq 'svg') { set terminal svg size " << kWidth << "," << kHeight
         << " dynamic enhanced background '#ffffff' font 'DejaVu Sans,23' } else { set terminal pngcairo size "
         << kWidth << "," << kHeight << " enhanced background '#ffffff' font 'DejaVu Sans,17' }\n"
         << "  set output kind eq 'svg' ? svg : png\n"
            "  set multiplot\n"
            "  set border 3 lc '#444444' lw 1.5\n"
            "  set tics out nomirror textcolor '#222222'\n"
            "  set grid lt 1 lc '#dddddd' lw 1\n"
            "  set logscale xy\n  set format xy '10^{%T}'\n  unset key\n"
         << "  set tmargin at screen " << screenY(ChartCanvas::kTop) << "\n  set bmargin at screen "
         << screenY(ChartCanvas::kBottom) << "\n"
         << "  set yrange [" << error_.y.low << ":" << error_.y.high << "]\n";
    textAt(chart_.title, 60, 50, "left", kInk, 1.4);
    for (std::size_t k = 0; k < chart_.notes.size(); ++k)
      textAt(chart_.notes[k], 60, 100 + 38 * double(k), "left", kGrey, 1);
    legend();
  }

  // Texts and lines at pixels of the canvas.

  void textAt(const std::string& text, double x, double y, const char* where, const std::string& colour, double scale) {
    label(text, "screen " + pair(screenX(x), screenY(y)), where, colour, scale);
  }
  void label(const std::string& text, const std::string& at, const char* where, const std::string& colour,
             double scale) {
    out_ << "  set label " << gnuplotQuoted(text) << " at " << at << " " << where
         << " font sprintf(',%g', (kind eq 'svg' ? 23 : 17) * " << scale << ") textcolor rgb '" << colour
         << "' noenhanced front\n";
  }
  void pointAt(double x, double y, int type, double pointSize, const std::string& colour) {
    out_ << "  set label '' at screen " << pair(screenX(x), screenY(y)) << " point pt " << type << " ps " << pointSize
         << " lw 2.5 lc rgb '" << colour << "' front\n";
  }
  static std::string pair(double x, double y) {
    std::ostringstream text;
    text << x << "," << y;
    return text.str();
  }

  void legend() {
    const double y = ChartCanvas::kBottom + 130;
    double x = 60;
    const auto entry = [&](int type, double pointSize, const char* colour, const std::string& text) {
      pointAt(x + 10, y, type, pointSize, colour);
      textAt(text, x + 32, y, "left", kInk, 0.9);
      x += 32 + 12.6 * double(text.size()) + 30;
    };
    std::ostringstream budget;
    budget << "finer steps take over " << chart_.runBudget << " s a run";
    entry(7, 2.2, kInk, "double");
    entry(6, 2.0, kInk, "float");
    entry(7, 0.9, "#999999", "below ten times the floor: not to be trusted");
    entry(2, 2.0, kInk, "failed");
    out_ << "  set arrow from screen " << pair(screenX(x), screenY(y)) << " to screen "
         << pair(screenX(x + 40), screenY(y)) << " head filled size screen 0.006,20 lw 2.5 lc rgb '" << kInk << "'\n";
    x += 30;
    textAt(budget.str(), x + 32, y, "left", kInk, 0.9);
    if (chart_.comparedDuration) {
      x += 32 + 12.6 * double(budget.str().size()) + 30;
      entry(7, 1.4, "#b0b0b0", "the file compared with");
    }
  }

  void draw(const ChartPanel& panel) {
    const bool seconds = panel.work == ChartPanel::Work::Seconds;
    out_ << "  set lmargin at screen " << screenX(panel.left) << "\n  set rmargin at screen " << screenX(panel.right)
         << "\n  set xrange [" << panel.x.low << ":" << panel.x.high << "]\n  set xlabel '"
         << (seconds ? "seconds of computing per simulated second" : "force evaluations per simulated second")
         << "' offset 0,-0.3\n  set ylabel '" << (seconds ? "error / size of the sheet" : "") << "' offset 0.5,0\n";
    band();
    slopes(panel);
    marks(panel);
    ends(panel);
    curves(panel);
    out_ << "  unset label\n  unset arrow\n  unset object\n";
  }

  void band() {
    const double strip = error_.y.at(1 - ErrorAxis::kStrip);
    out_ << "  set object rectangle from graph 0,first " << strip
         << " to graph 1,1 fc rgb '#f3e3e3' fs solid noborder behind\n";
    const double floor = chart_.floorOfDouble / chart_.size;
    if (floor > error_.y.low) {
      out_ << "  set object rectangle from graph 0,0 to graph 1,first " << std::min(floor, strip)
           << " fc rgb '#dcdcdc' fs solid noborder behind\n";
    }
  }

  /// A horizontal line with a text on it at the left.
  void level(double value, const std::string& text, const char* colour, int dash) {
    if (!(value > error_.y.low && value < error_.y.at(1 - ErrorAxis::kStrip))) return;
    out_ << "  set arrow from graph 0,first " << value << " to graph 1,first " << value << " nohead lw 2 dt " << dash
         << " lc rgb '" << colour << "' back\n";
    label(text, "graph 0.012,first " + pair1(value * std::pow(error_.y.high / error_.y.low, 0.014)), "left", colour,
          0.8);
  }
  static std::string pair1(double value) {
    std::ostringstream text;
    text << value;
    return text.str();
  }

  void marks(const ChartPanel& panel) {
    const bool seconds = panel.work == ChartPanel::Work::Seconds;
    level(chart_.floorOfFloat / chart_.size, seconds ? "floor of float" : "", kGrey, 3);
    level(chart_.floorOfDouble / chart_.size, seconds ? "floor of double" : "", kGrey, 3);
    if (chart_.spatial) {
      level(chart_.spatial->distance / chart_.size, "", kSpatial, 2);
      if (!seconds) spatialText(panel);
    }
    if (seconds) realTime(panel);
  }

  /// Above the line's right end, where curves of force evaluations are seldom.
  void spatialText(const ChartPanel& panel) {
    const std::string grid = std::to_string(chart_.spatial->columns) + "x" + std::to_string(chart_.spatial->rows);
    const double y = pixelY(error_, chart_.spatial->distance / chart_.size) - 18;
    const std::string text = "as " + grid + " this cloth is this far away: smaller errors are not seen";
    textAt(text, panel.right, y, "right", kSpatial, 0.8);
  }

  void realTime(const ChartPanel& panel) {
    if (panel.x.place(1) <= 0 || panel.x.place(1) >= 1) return;
    out_ << "  set arrow from first 1,graph 0 to first 1,graph " << 1 - ErrorAxis::kStrip
         << " nohead lw 2.5 dt 4 lc rgb '" << kInk
         << "' back\n  set label 'real time: 16.7 ms for a frame of 60 Hz' at first 1,graph 0.02 rotate by 90 left "
         << "offset -1.3,0 font sprintf(',%g', (kind eq 'svg' ? 23 : 17) * 0.8) textcolor rgb '" << kInk << "' front\n";
  }

  /// Lines that fall as fast as errors of order 1, 2 and 4 do, in the lower left corner.
  void slopes(const ChartPanel& panel) {
    const double x0 = 0.05, y0 = 0.2, fall = 1;  // panel fractions; decades
    const double xDecades = std::log10(panel.x.high / panel.x.low), yDecades = std::log10(error_.y.high / error_.y.low);
    for (const int order : {1, 2, 4}) {
      const double x1 = x0 + fall / order / xDecades, y1 = y0 - fall / yDecades;
      out_ << "  set arrow from graph " << pair(x0, y0) << " to graph " << pair(x1, y1) << " nohead lw 2 lc rgb '"
           << kGrey << "' back\n";
      label(std::to_string(order), "graph " + pair(x1, y1 - 0.022), "center", kGrey, 0.9);
    }
    label("order", "graph " + pair(x0, y0 + 0.02), "left", kGrey, 0.9);
  }

  [[nodiscard]] bool inPanel(const ChartPanel& panel, double x, double y) const {
    return panel.x.place(x) >= 0 && panel.x.place(x) <= 1 && error_.y.place(y) >= 0 && error_.y.place(y) <= 1;
  }

  /// A method's name at the end of its curve.
  void ends(const ChartPanel& panel) {
    std::vector<std::string> shown;
    std::vector<WantedLabel> wanted;
    std::vector<std::vector<Pixel>> lines;
    for (const std::string& method : methods_) {
      lines.push_back(curveOf(chart_, panel, error_, method, Precision::Double));
      lines.push_back(curveOf(chart_, panel, error_, method, Precision::Float));
      const WorkRow* end = endOfCurve(chart_, method);
      const double work = end == nullptr ? 0 : panel.workOf(*end, chart_.duration);
      if (end == nullptr || !inPanel(panel, work, end->rmsError / chart_.size)) continue;
      const Pixel at{pixelX(panel, work), pixelY(error_, end->rmsError / chart_.size)};
      if (tooSlow(method)) {
        const std::vector<Pixel>& curve = lines.end()[lines.end()[-2].empty() ? -1 : -2];
        arrowAfter(curve.back(), lookOf(method).colour);
        lines.push_back({curve.back(), {curve.back().x + kArrow, curve.back().y}});
      }
      shown.push_back(method);
      wanted.push_back({{at.x + kArrow - 10, at.y}, kCharacter * double(method.size()), 34});
    }
    std::vector<PixelBox> taken;
    if (panel.work == ChartPanel::Work::Seconds) {
      const double x = pixelX(panel, 1);  // the line of real time and its text
      lines.push_back({{x, ChartCanvas::kTop}, {x, ChartCanvas::kBottom}});
      taken.push_back({x - 34, x + 4, ChartCanvas::kBottom - 410, ChartCanvas::kBottom});
    } else if (chart_.spatial) {
      const double y = pixelY(error_, chart_.spatial->distance / chart_.size);
      taken.push_back({panel.right - 660, panel.right, y - 34, y + 2});
    }
    std::vector<double> levels{chart_.floorOfFloat, chart_.floorOfDouble};
    if (chart_.spatial) levels.push_back(chart_.spatial->distance);
    for (const double at : levels) {
      const double y = pixelY(error_, at / chart_.size);
      lines.push_back({{panel.left, y}, {panel.right, y}});
    }
    const PixelBox bounds{panel.left, panel.right + kBeside, ChartCanvas::kTop + 60, ChartCanvas::kBottom - 5};
    const std::vector<PixelBox> boxes = placeLabels(wanted, lines, taken, bounds);
    for (std::size_t k = 0; k < shown.size(); ++k) nameAt(boxes[k], wanted[k].at, shown[k]);
    failedOnes(panel);
  }

  void nameAt(const PixelBox& box, const Pixel& end, const std::string& method) {
    const std::string colour = lookOf(method).colour;
    const double centre = (box.top + box.bottom) / 2;
    textAt(method, box.left, centre, "left", colour, 1);
    const double near = std::clamp(end.x, box.left - 6, box.right + 6);
    if (std::hypot(near - end.x, centre - end.y) > 45) {
      const double y = near == end.x ? (centre < end.y ? box.bottom : box.top) : centre;
      out_ << "  set arrow from screen " << pair(screenX(end.x), screenY(end.y)) << " to screen "
           << pair(screenX(near), screenY(y)) << " nohead lw 1.2 lc rgb '" << pale(colour, "60") << "' back\n";
    }
  }

  /// Methods without a curve are named beside the strip of failures.
  void failedOnes(const ChartPanel& panel) {
    double y = ChartCanvas::kTop + ErrorAxis::kStrip / 2 * (ChartCanvas::kBottom - ChartCanvas::kTop);
    textAt("failed:", panel.left, ChartCanvas::kTop - 18, "left", kGrey, 0.8);
    for (const std::string& method : methods_) {
      if (endOfCurve(chart_, method) != nullptr) continue;
      textAt((tooSlow(method) ? "\u2192 " : "\u00d7 ") + method, panel.right + 10, y, "left", lookOf(method).colour,
             0.95);
      y -= 34;
    }
  }

  [[nodiscard]] bool tooSlow(const std::string& method) const {
    return std::ranges::any_of(chart_.rows, [&](const WorkRow& row) {
      return row.integrator == method && row.precision == Precision::Double && row.status == RowStatus::TooSlow;
    });
  }

  void arrowAfter(const Pixel& at, const std::string& colour) {
    out_ << "  set arrow from screen " << pair(screenX(at.x), screenY(at.y)) << " to screen "
         << pair(screenX(at.x + kArrow), screenY(at.y)) << " head filled size screen 0.006,20 lw 2.5 lc rgb '" << colour
         << "' front\n";
  }

  void curves(const ChartPanel& panel) {
    const std::string work = panel.work == ChartPanel::Work::Seconds ? "10" : "9";
    out_ << "  plot NaN notitle";
    if (chart_.comparedDuration) earlier(work);
    for (const std::string& method : methods_) {
      const Look look = lookOf(method);
      for (const char* precision : {"float", "double"}) curve(method, precision, work, look);
    }
    out_ << "\n";
  }

  void curve(const std::string& method, const std::string& precision, const std::string& work, const Look& look) {
    const bool isDouble = precision == "double";
    const std::string wanted = "(is(" + gnuplotQuoted(method) + ",'" + precision + "'))";
    const std::string x = "($" + work + " / simulated(duration))";
    const auto plot = [&](const std::string& y, const std::string& with) {
      out_ << ", \\\n       'rows.csv' skip 1 using " << x << ":(" << y << wanted << ") with " << with;
    };
    const std::string colour = "lc rgb '" + (isDouble ? look.colour : pale(look.colour, "50")) + "'";
    plot("error",
         "lines " + std::string(isDouble ? "lw 3.5" : "lw 1.6") + " dt " + std::to_string(look.dash) + " " + colour);
    plot("doubtful", "points pt 7 ps 0.9 lc rgb '" + pale(look.colour, "80") + "'");
    plot("trusted", isDouble ? "points pt " + std::to_string(look.filled) + " ps 2.1 " + colour
                             : "points pt " + std::to_string(look.hollow) + " ps 1.6 lw 1.6 " + colour);
    plot("failure", std::string("points pt 2 ") + (isDouble ? "ps 2.2 lw 3 " : "ps 1.3 lw 1.6 ") + colour);
  }

  void earlier(const std::string& work) {
    for (const std::string& method : methods_) {
      for (const char* precision : {"float", "double"}) {
        out_ << ", \\\n       'compare.csv' skip 1 using ($" << work << " / " << *chart_.comparedDuration
             << "):(error(is(" << gnuplotQuoted(method) << ",'" << precision
             << "'))) with linespoints pt 7 ps 1.2 lw 7 lc rgb '#c8c8c8'";
      }
    }
  }

  const WorkChart& chart_;
  std::vector<ChartPanel> panels_;
  ErrorAxis error_;
  std::vector<std::string> methods_;
  std::ostringstream out_;
};

}  // namespace

std::string workChartScript(const WorkChart& chart) { return Script(chart).text(); }

}  // namespace tyg

// One panel: the error, the distance of the explanation, and the floor below which nothing can be told, on a
// logarithmic axis.
#include "study/charts/check_chart.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "study/charts/chart_script.h"
#include "study/charts/gnuplot.h"
#include "util/amounts.h"

namespace tyg {
namespace {

// In pixels of the PNG, and of the SVG before it is scaled.
constexpr double kWidth = 1600, kHeight = 900, kLeft = 190, kRight = 50, kTop = 280, kBottom = 140;
constexpr double kHead = 140, kLegendRow = 44, kSampleWidth = 120;

struct Curve {
  int column;
  std::string words, style;
};

std::string explanationWords(const MotionCheck& check) {
  const Explanation* of = check.explanation();
  if (of == nullptr) return "";
  std::string words = "distance from " + std::string(of->way.name());
  if (of->dt > 0) words += " at " + timeText(of->dt);
  for (const Mistake* mistake : of->model.made)
    words += (mistake == of->model.made.front() ? ", " : " and ") + std::string(mistake->name);
  return words;
}

std::vector<Curve> curvesOf(const MotionCheck& check) {
  std::vector<Curve> curves{
      {2, "error: distance from the exact motion", fmt::format("lw 4 dt 1 lc '{}'", chartColour(0))}};
  if (const std::string words = explanationWords(check); !words.empty()) {
    curves.push_back({3, words, fmt::format("lw 4 dt (9,5) lc '{}'", chartColour(1))});
  }
  curves.push_back({4, "floor: the exact motion is known no better", "lw 3 dt (3,3) lc '#888888'"});
  return curves;
}

/// Whole decades around all that is drawn, so that there are labelled tics.
std::pair<double, double> decadesOf(const MotionCheck& check) {
  double low = check.size, high = 0;
  const auto include = [&](double value) {
    if (!(value > 0) || !std::isfinite(value)) return;
    low = std::min(low, value), high = std::max(high, value);
  };
  std::ranges::for_each(check.errors, include);
  std::ranges::for_each(check.explained, include);
  include(check.reference.floorAt(0, Precision::Double));
  constexpr double kLeast = 1e-18;
  if (high <= 0) high = low;
  const double top = std::ceil(std::log10(1.1 * high));
  return {std::min(std::floor(std::log10(std::max(low, kLeast))), top - 1), top};
}

}  // namespace

std::string checkScript(const MotionCheck& check) {
  constexpr int kLetters = 22, kDigits = 12;
  ChartScript script(kWidth, kHeight, kLetters, kDigits);
  script.add("# Draws check.svg and check.png from check.csv:  gnuplot check.gp\nset datafile separator comma\n");
  script.namePictures("check");
  script.beginPictures();
  const auto [low, high] = decadesOf(check);
  script.add("  set grid lt 1 lc '#d0d0d0' lw 1\n  set xrange [0:{:.12g}]\n  set logscale y\n", check.scene.duration);
  script.add("  set yrange [1e{:g}:1e{:g}]\n  set format y '10^{{%T}}'\n", low, high);
  script.add("  set xlabel 'time (s)'\n  set ylabel 'distance, RMS over particles (m)'\n");
  script.title(check.scene.title, "how wrong a motion is", {kLeft, 45});
  const std::string mistake = mistakeName(check);
  const bool explained = check.verdict != MotionCheck::Verdict::Unexplained;
  script.label(!mistake.empty() ? "mistake: " + mistake
               : explained      ? "no mistake found"
                                : "not explained",
               {kLeft, 95}, {.colour = "#555555"});
  script.panel({kLeft, kWidth - kRight, kTop, kHeight - kBottom});
  const std::vector<Curve> curves = curvesOf(check);
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const Pixel at{kLeft, kHead + kLegendRow * double(k)};
    const double y = 1 - at.y / kHeight;
    script.add("  set arrow from screen {:.12g},{:.12g} to screen {:.12g},{:.12g} nohead {}\n", at.x / kWidth, y,
               (at.x + kSampleWidth - 30) / kWidth, y, curves[k].style);
    script.label(curves[k].words, {at.x + kSampleWidth - 15, at.y}, {.colour = "#000000"});
  }
  script.add("  plot ");
  for (std::size_t k = 0; k < curves.size(); ++k) {
    script.add("{}'check.csv' skip 1 using 1:(${} > 0 ? ${} : NaN) with linespoints pt 7 ps 0.4 {}",
               k > 0 ? ", \\\n       " : "", curves[k].column, curves[k].column, curves[k].style);
  }
  script.add("\n  unset label\n  unset arrow\n");
  script.endPictures();
  return script.text();
}

}  // namespace tyg

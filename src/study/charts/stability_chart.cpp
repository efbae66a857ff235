// Lays out the chart of step limits: a row a method above, a panel a method below.
#include "study/charts/stability_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include "study/charts/chart_script.h"
#include "study/charts/gnuplot.h"
#include "study/limits/stability_region.h"

namespace tyg {
namespace {

// In pixels of the PNG, and of the SVG before it is scaled.
constexpr double kWidth = 1600, kHead = 170, kRow = 34, kLegend = 60, kLeft = 370, kRight = 60;
constexpr double kBelowRows = 185, kPanel = 430, kPanelHead = 70, kPanelLeft = 115, kPanelBottom = 70;
constexpr int kPanelsAcross = 3;
constexpr const char* kInk = "#222222";
constexpr const char* kGrey = "#666666";
constexpr const char* kRegion = "#d9e6f2";

struct Quantity {
  const char* words;
  int type;  // gnuplot's point
  double size;
  std::size_t colour;
  double (*of)(const StabilityCase&);
};
/// Drawn in this order: a prediction that agrees lies on its measurement.
constexpr std::array<Quantity, 4> kQuantities{{
    {"measured, in the scene's motion", 13, 1.9, 2, [](const StabilityCase& c) { return c.inMotion; }},
    {"measured, around rest", 6, 2.0, 1, [](const StabilityCase& c) { return c.atRest; }},
    {"predicted", 2, 1.3, 6, [](const StabilityCase& c) { return c.limit.predicted; }},
    {"certified for any deformation", 9, 1.6, 0, [](const StabilityCase& c) { return c.limit.certified; }},
}};

bool canBeDrawn(double step) { return std::isfinite(step) && step > 0; }

/// Which rows and panels the chart has, and where they are.
struct Layout {
  std::vector<const StabilityCase*> rows;
  std::vector<const Method*> panels;
  double bottomOfRows = 0, height = 0;  // pixels
};

Layout layoutOf(const StabilityStudy& study) {
  Layout layout;
  for (const StabilityCase& entry : study.cases) {
    if (std::ranges::any_of(kQuantities, [&](const Quantity& q) { return canBeDrawn(q.of(entry)); })) {
      layout.rows.push_back(&entry);
    }
    const bool hasRegion = entry.method->stableStep != nullptr || entry.method->stableStepOfScene != nullptr;
    const bool isNew = layout.panels.empty() || layout.panels.back() != entry.method;
    if (hasRegion && isNew) layout.panels.push_back(entry.method);
  }
  layout.bottomOfRows = kHead + kLegend + kRow * double(layout.rows.size());
  const double across = std::ceil(double(layout.panels.size()) / kPanelsAcross);
  layout.height = layout.bottomOfRows + kBelowRows + across * (kPanel + kPanelHead);
  return layout;
}

void addLimitData(const Layout& layout, ChartScript& script) {
  for (std::size_t q = 0; q < kQuantities.size(); ++q) {
    script.add("$limits{} << END   # ms, row\n", q);
    for (std::size_t k = 0; k < layout.rows.size(); ++k) {
      const double step = kQuantities.at(q).of(*layout.rows[k]);
      if (canBeDrawn(step)) script.add("{:.8g} {}\n", 1e3 * step, k + 1);
    }
    script.add("END\n");
  }
}

struct Roots {
  std::vector<std::complex<double>> ofSheet, held;  // held: of a particle on a body
};

/// A panel's part of the plane of z = h mu.
struct Extent {
  double left = 0, top = 0;  // from 0
};

/// Fits a panel to the region and to the roots, up to four times the region: beyond, the region would be a dot.
Extent extentOf(const StabilityRegion& region, const Roots& roots, double h) {
  Extent extent;
  for (const std::complex<double>& z : region.edge) {
    extent.left = std::max(extent.left, -z.real());
    extent.top = std::max(extent.top, std::abs(z.imag()));
  }
  if (std::isfinite(region.onRealAxis)) extent.left = std::max(extent.left, region.onRealAxis);
  double left = 0, top = 0;
  for (const auto* some : {&roots.ofSheet, &roots.held}) {
    for (const std::complex<double>& mu : *some) {
      left = std::max(left, -h * mu.real());
      top = std::max(top, h * std::abs(mu.imag()));
    }
  }
  constexpr double kMost = 4, kMargin = 1.12;
  const auto fitted = [](double ofRegion, double farthest) {
    const double least = std::max(ofRegion, 0.1);
    return kMargin * std::clamp(farthest, least, kMost * least);
  };
  return {fitted(extent.left, left), fitted(extent.top, top)};
}

/// A method's panel, once its data are written.
struct RegionPanel {
  const Method* method;
  Extent extent;
  double onRealAxis;    // as StabilityRegion::onRealAxis
  std::string verdict;  // what the roots say, for people
};

/// Writes the edge of the stable region, and the scene's roots inside and outside of it.
RegionPanel addRegionData(std::size_t k, const Method& method, const Scene& scene, const Roots& roots,
                          ChartScript& script) {
  const double h = scene.dt;
  const StabilityRegion region = regionOf(method, scene, h);
  const Extent extent = extentOf(region, roots, h);
  script.add("$region{} << END   # z = h mu\n0 0\n", k);
  for (const std::complex<double>& z : region.edge) script.add("{:.8g} {:.8g}\n", z.real(), z.imag());
  script.add("0 0\nEND\n");
  std::size_t unstable = 0;
  bool anyBeyond = false;
  std::string inside, outside;
  const auto add = [&](const std::complex<double>& mu, bool held) {
    const std::complex<double> z = h * mu;
    const bool holds = holdsAt(method, region, mu, h, held);
    if (!holds) ++unstable;
    anyBeyond = anyBeyond || -z.real() > extent.left || std::abs(z.imag()) > extent.top;
    (holds ? inside : outside) += fmt::format("{:g} {:g}\n", z.real(), z.imag());
  };
  for (const std::complex<double>& mu : roots.ofSheet) add(mu, false);
  for (const std::complex<double>& mu : roots.held) add(mu, true);
  const std::size_t count = roots.ofSheet.size() + roots.held.size();
  script.add("$inside{} << END\n{}END\n$outside{} << END\n{}END\n", k, inside, k, outside);
  std::string verdict = region.stages.count > 0 ? fmt::format("{} stages; ", region.stages.count) : "";
  verdict += unstable == 0 ? "all modes hold"
                           : fmt::format("{} % grow (crosses)", std::max<std::size_t>(1, 100 * unstable / count));
  if (anyBeyond) verdict += "; some lie beyond";
  return {&method, extent, region.onRealAxis, verdict};
}

void addTitle(const Scene& scene, ChartScript& script) {
  script.title(scene.title, "the largest stable step, predicted and measured", {60, 50});
  script.label(
      fmt::format("{} x {} particles; measured by bisection on the energy alarm; the dashed line is h = {:g} ms",
                  scene.columns, scene.rows, 1e3 * scene.dt),
      {60, 100}, {.colour = kGrey});
  static constexpr std::array kAt{60.0, 500.0, 830.0, 1040.0};
  for (std::size_t q = 0; q < kQuantities.size(); ++q) {
    const Quantity& quantity = kQuantities.at(q);
    script.point({kAt.at(q) + 12, 150}, quantity.type, quantity.size, chartColour(quantity.colour));
    script.label(quantity.words, {kAt.at(q) + 34, 150}, {.colour = kInk, .scale = 0.9});
  }
}

/// In place of the rows, and in a plot of nothing: gnuplot draws texts with a plot alone.
void addNoLimits(ChartScript& script) {
  script.label("none: no step is known beyond which these methods fail", {60, kHead + kLegend}, {.colour = kInk});
  script.add("  unset border\n  unset tics\n  plot [0:1] [0:1] NaN\n  unset label\n");
  script.add(ChartScript::kFrame);
}

void addLimits(const Layout& layout, double dt, ChartScript& script) {
  const double top = kHead + kLegend / 2, count = double(layout.rows.size());
  script.panel({kLeft, kWidth - kRight, top, top + kRow * count + 10});
  script.add(
      "  set logscale x\n  set format x '%g'\n  set xlabel 'step, ms' offset 0,0.3\n  set yrange [{:.8g}:0.3]\n"
      "  set xrange [*:*] extend\n  set ytics (",
      count + 0.7);
  for (std::size_t k = 0; k < layout.rows.size(); ++k) {
    const StabilityCase& row = *layout.rows[k];
    const std::string name = std::string(row.method->name) + (row.damped ? "" : ", undamped");
    script.add("{}{} {}", k == 0 ? "" : ", ", gnuplotQuoted(name), k + 1);
  }
  script.add(
      ")\n  set offsets graph 0.03, graph 0.03, 0, 0\n  set arrow from {0:.8g}, graph 0 to {0:.8g}, graph 1 nohead "
      "dt 2 lw 2 lc '{1}' back\n  plot ",
      1e3 * dt, kGrey);
  for (std::size_t q = 0; q < kQuantities.size(); ++q) {
    const Quantity& quantity = kQuantities.at(q);
    script.add("{}$limits{} using 1:2 with points pt {} ps {:g} lw 2.5 lc rgb '{}'", q == 0 ? "" : ", ", q,
               quantity.type, quantity.size, chartColour(quantity.colour));
  }
  script.add("\n  unset arrow\n  unset label\n  unset logscale x\n  set offsets 0,0,0,0\n  set ytics autofreq\n");
}

void addRegion(std::size_t k, const RegionPanel& panel, double topOfPanels, ChartScript& script) {
  const double x = double(k % kPanelsAcross) * kWidth / kPanelsAcross, right = x + kWidth / kPanelsAcross - 30;
  const std::size_t row = k / kPanelsAcross;
  const double y = topOfPanels + double(row) * (kPanel + kPanelHead);
  const Extent& extent = panel.extent;
  script.label(std::string(panel.method->name), {x + kPanelLeft, y - 8}, {.colour = kInk});
  script.label(panel.verdict, {right, y - 8}, {.colour = kGrey, .scale = 0.8, .side = ChartScript::Side::Right});
  script.panel({x + kPanelLeft, right, y + 12, y + kPanel - kPanelBottom});
  script.add(
      "  set format x '%g'\n  set xlabel 'Re z' offset 0,0.5\n  set ylabel {} offset 0.6,0\n"
      "  set xrange [{:.8g}:{:.8g}]\n  set yrange [{:.8g}:{:.8g}]\n  set xtics autofreq\n",
      k % kPanelsAcross == 0 ? "'Im z'" : "''", -extent.left, 0.06 * extent.left, -extent.top, extent.top);
  script.add("  set arrow from {:.8g},0 to 0,0 nohead lw 5 lc rgb '#9fbfdd' back\n",
             -std::min(panel.onRealAxis, extent.left));
  script.add("  plot $region{} using 1:2 with filledcurves closed fc rgb '{}' fs solid border lc rgb '{}', ", k,
             kRegion, chartColour(0));
  script.add(
      "$inside{0} using 1:2 with points pt 7 ps 0.35 lc rgb '{1}', $outside{0} using 1:2 with points pt 2 ps 0.7 lw "
      "1.5 "
      "lc rgb '{2}'\n  unset arrow\n  unset label\n",
      k, kInk, chartColour(1));
}

}  // namespace

std::string stabilityScript(const StabilityStudy& study) {
  Scene scene = study.scene;
  scene.dt = std::min(scene.dt, scene.duration);  // as every run cuts its steps; beyond, h mu may have no number
  const Layout layout = layoutOf(study);
  constexpr int kLetters = 23, kDigits = 8;
  ChartScript script(kWidth, layout.height, kLetters, kDigits);
  script.add("# Draws stability.svg and stability.png:  gnuplot stability.gp\n");
  script.namePictures("stability");
  addLimitData(layout, script);
  const Roots roots{sceneRoots(scene), heldRoots(scene)};
  std::vector<RegionPanel> panels;
  for (std::size_t k = 0; k < layout.panels.size(); ++k) {
    panels.push_back(addRegionData(k, *layout.panels[k], scene, roots, script));
  }
  script.beginPictures();
  script.add("  set grid lt 1 lc '#dddddd' lw 1\n");
  addTitle(scene, script);
  layout.rows.empty() ? addNoLimits(script) : addLimits(layout, scene.dt, script);
  const double topOfPanels = layout.bottomOfRows + kBelowRows;
  if (!panels.empty()) {
    script.label(fmt::format("Stable regions (shaded) and the scene's own modes{}: z = h mu at h = {:g} ms",
                             roots.held.empty() ? "" : ", those of a particle on a body too", 1e3 * scene.dt),
                 {60, topOfPanels - 62}, {.colour = kInk, .scale = 1.15});
  }
  for (std::size_t k = 0; k < panels.size(); ++k) addRegion(k, panels[k], topOfPanels, script);
  script.endPictures();
  return script.text();
}

}  // namespace tyg

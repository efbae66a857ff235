// Lays out the chart of step limits: a row a method above, a panel a method below.
#include "study/charts/stability_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>

#include "study/charts/chart_pen.h"
#include "study/charts/gnuplot.h"

namespace tyg {
namespace {

// In pixels of the PNG, and of the SVG before it is scaled.
constexpr double kWidth = 1600, kHead = 170, kRow = 34, kLegend = 60, kLeft = 370, kRight = 60;
constexpr double kPanel = 430, kPanelHead = 70, kPanelLeft = 115, kPanelBottom = 70;
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

class Script {
 public:
  explicit Script(const StabilityStudy& study) : study_(study) {
    for (const StabilityCase& entry : study.cases) {
      if (std::ranges::any_of(kQuantities, [&](const Quantity& q) { return canBeDrawn(q.of(entry)); })) {
        rows_.push_back(&entry);
      }
      const bool hasRegion = entry.method->stableStep != nullptr || entry.method->stableStepOfScene != nullptr;
      if (hasRegion && (panels_.empty() || panels_.back() != entry.method)) panels_.push_back(entry.method);
    }
    bottomOfRows_ = kHead + kLegend + kRow * double(rows_.size());
    const double across = std::ceil(double(panels_.size()) / kPanelsAcross);
    height_ = bottomOfRows_ + 185 + across * (kPanel + kPanelHead);
    pen_.emplace(out_, kWidth, height_);
  }

  std::string text() {
    out_.precision(8);
    out_ << "# Step limits of " << study_.scene.name << ". Draws svg and png, which are file names: by hand\n"
         << "#   gnuplot stability.gp\n";
    namePictures(out_, "stability");
    limitData();
    const std::vector<std::complex<double>> roots = sceneRoots(study_.scene);
    for (std::size_t k = 0; k < panels_.size(); ++k) regionData(k, roots);
    beginPictures(out_, kWidth, height_);
    out_ << "  set grid lt 1 lc '#dddddd' lw 1\n";
    limits();
    for (std::size_t k = 0; k < panels_.size(); ++k) panel(k);
    endPictures(out_);
    return out_.str();
  }

 private:
  struct Extent {
    double left = 0, top = 0;  // of the plane of h mu
    std::size_t beyond = 0;    // roots that lie outside
    std::size_t roots = 0, unstable = 0;
    int stages = 0;
    double onRealAxis = 0;
  };

  void limitData() {
    for (std::size_t q = 0; q < kQuantities.size(); ++q) {
      out_ << "$limits" << q << " << END   # ms, row\n";
      for (std::size_t k = 0; k < rows_.size(); ++k) {
        const double step = kQuantities.at(q).of(*rows_[k]);
        if (canBeDrawn(step)) out_ << 1e3 * step << " " << k + 1 << "\n";
      }
      out_ << "END\n";
    }
  }

  /// The edge of the stable region, and the scene's roots inside and outside of it.
  void regionData(std::size_t k, const std::vector<std::complex<double>>& roots) {
    const Method& method = *panels_[k];
    const double h = study_.scene.dt;
    const StabilityRegion region = regionOf(method, study_.scene, h);
    Extent extent;
    extent.stages = region.stages.count;
    extent.onRealAxis = region.onRealAxis;
    out_ << "$region" << k << " << END   # z = h mu\n0 0\n";
    for (const std::complex<double>& z : region.edge) {
      out_ << z.real() << " " << z.imag() << "\n";
      extent.left = std::max(extent.left, -z.real());
      extent.top = std::max(extent.top, std::abs(z.imag()));
    }
    if (std::isfinite(region.onRealAxis)) extent.left = std::max(extent.left, region.onRealAxis);
    out_ << "0 0\nEND\n";
    fitRoots(extent, roots, h);
    extent.roots = roots.size();
    std::ostringstream inside, outside;
    for (const std::complex<double>& mu : roots) {
      const std::complex<double> z = h * mu;
      const bool holds = holdsAt(method, region, mu, h);
      if (!holds) ++extent.unstable;
      if (-z.real() > extent.left || std::abs(z.imag()) > extent.top) ++extent.beyond;
      (holds ? inside : outside) << z.real() << " " << z.imag() << "\n";
    }
    out_ << "$inside" << k << " << END\n" << inside.str() << "END\n";
    out_ << "$outside" << k << " << END\n" << outside.str() << "END\n";
    extents_.push_back(extent);
  }

  /// Widens a panel to the roots, up to four times the region: beyond, the region would be a dot.
  static void fitRoots(Extent& extent, const std::vector<std::complex<double>>& roots, double h) {
    constexpr double kMost = 4, kMargin = 1.12;
    const auto fitted = [](double region, double farthest) {
      return kMargin * std::clamp(farthest, region, kMost * region);
    };
    double left = 0, top = 0;
    for (const std::complex<double>& mu : roots) {
      left = std::max(left, -h * mu.real());
      top = std::max(top, h * std::abs(mu.imag()));
    }
    extent.left = fitted(std::max(extent.left, 0.1), left);
    extent.top = fitted(std::max(extent.top, 0.1), top);
  }

  void margins(double left, double right, double top, double bottom) {
    out_ << "  set lmargin at screen " << left / kWidth << "\n  set rmargin at screen " << right / kWidth
         << "\n  set tmargin at screen " << 1 - top / height_ << "\n  set bmargin at screen " << 1 - bottom / height_
         << "\n";
  }

  void limits() {
    const Scene& scene = study_.scene;
    std::ostringstream size, step;
    size << scene.columns << " x " << scene.rows
         << " particles; measured by bisection on the energy alarm; the dashed line is h = " << 1e3 * scene.dt << " ms";
    pen_->text(scene.title + ": the largest stable step, predicted and measured", {60, 50},
               {.colour = kInk, .scale = 1.4});
    pen_->text(size.str(), {60, 100}, {.colour = kGrey});
    for (std::size_t q = 0; q < kQuantities.size(); ++q) {
      const Quantity& quantity = kQuantities.at(q);
      static constexpr std::array kAt{60.0, 500.0, 830.0, 1040.0};
      pen_->point({kAt.at(q) + 12, 150}, quantity.type, quantity.size, chartColour(quantity.colour));
      pen_->text(quantity.words, {kAt.at(q) + 34, 150}, {.colour = kInk, .scale = 0.9});
    }
    if (rows_.empty()) return noLimits();
    const double top = kHead + kLegend / 2;
    margins(kLeft, kWidth - kRight, top, top + kRow * double(rows_.size()) + 10);
    out_ << "  set logscale x\n  set format x '%g'\n  set xlabel 'step, ms' offset 0,0.3\n  set yrange ["
         << double(rows_.size()) + 0.7 << ":0.3]\n  set xrange [*:*] extend\n  set ytics (";
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      out_ << (k == 0 ? "" : ", ")
           << gnuplotQuoted(std::string(rows_[k]->method->name) + (rows_[k]->damped ? "" : ", undamped")) << " "
           << k + 1;
    }
    out_ << ")\n  set offsets graph 0.03, graph 0.03, 0, 0\n  set arrow from " << 1e3 * scene.dt << ", graph 0 to "
         << 1e3 * scene.dt << ", graph 1 nohead dt 2 lw 2 lc '" << kGrey << "' back\n  plot ";
    for (std::size_t q = 0; q < kQuantities.size(); ++q) {
      const Quantity& quantity = kQuantities.at(q);
      out_ << (q == 0 ? "" : ", ") << "$limits" << q << " using 1:2 with points pt " << quantity.type << " ps "
           << quantity.size << " lw 2.5 lc rgb '" << chartColour(quantity.colour) << "'";
    }
    out_ << "\n  unset arrow\n  unset label\n  unset logscale x\n  set offsets 0,0,0,0\n  set ytics autofreq\n";
  }

  /// In place of the rows, and in a plot of nothing: gnuplot draws texts with a plot alone.
  void noLimits() {
    pen_->text("none: no step is known beyond which these methods fail", {60, kHead + kLegend}, {.colour = kInk});
    out_ << "  unset border\n  unset tics\n  plot [0:1] [0:1] NaN\n  unset label\n" << kChartFrame;
  }

  void panel(std::size_t k) {
    const double x = double(k % kPanelsAcross) * kWidth / kPanelsAcross;
    const std::size_t row = k / kPanelsAcross;
    const double y = bottomOfRows_ + 185 + double(row) * (kPanel + kPanelHead);
    const Extent& extent = extents_[k];
    if (k == 0) {
      std::ostringstream head;
      head << "Stable regions (shaded) and the scene's own modes: z = h mu at h = " << 1e3 * study_.scene.dt << " ms";
      pen_->text(head.str(), {60, y - 62}, {.colour = kInk, .scale = 1.15});
    }
    pen_->text(std::string(panels_[k]->name), {x + kPanelLeft, y - 8}, {.colour = kInk});
    pen_->text(verdict(extent), {x + kWidth / kPanelsAcross - 30, y - 8},
               {.colour = kGrey, .scale = 0.8, .side = ChartPen::Side::Right});
    margins(x + kPanelLeft, x + kWidth / kPanelsAcross - 30, y + 12, y + kPanel - kPanelBottom);
    out_ << "  set format x '%g'\n  set xlabel 'Re z' offset 0,0.5\n  set ylabel "
         << (k % kPanelsAcross == 0 ? "'Im z'" : "''") << " offset 0.6,0\n  set xrange [" << -extent.left << ":"
         << 0.06 * extent.left << "]\n  set yrange [" << -extent.top << ":" << extent.top
         << "]\n  set xtics autofreq\n";
    const double bar = std::min(extent.onRealAxis, extent.left);
    out_ << "  set arrow from " << -bar << ",0 to 0,0 nohead lw 5 lc rgb '#9fbfdd' back\n"
         << "  plot $region" << k << " using 1:2 with filledcurves closed fc rgb '" << kRegion
         << "' fs solid border lc rgb '" << chartColour(0) << "', $inside" << k
         << " using 1:2 with points pt 7 ps 0.35 lc rgb '" << kInk << "', $outside" << k
         << " using 1:2 with points pt 2 ps 0.7 lw 1.5 lc rgb '" << chartColour(1) << "'\n"
         << "  unset arrow\n  unset label\n";
  }

  static std::string verdict(const Extent& extent) {
    std::string words;
    if (extent.stages > 0) words = std::to_string(extent.stages) + " stages; ";
    words += extent.unstable == 0
                 ? "all modes hold"
                 : std::to_string(std::max<std::size_t>(1, 100 * extent.unstable / extent.roots)) + " % grow (crosses)";
    if (extent.beyond > 0) words += "; some lie beyond";
    return words;
  }

  const StabilityStudy& study_;
  std::ostringstream out_;
  std::optional<ChartPen> pen_;
  std::vector<const StabilityCase*> rows_;
  std::vector<const Method*> panels_;
  std::vector<Extent> extents_;
  double bottomOfRows_ = 0, height_ = 0;
};

}  // namespace

std::string stabilityScript(const StabilityStudy& study) { return Script(study).text(); }

}  // namespace tyg

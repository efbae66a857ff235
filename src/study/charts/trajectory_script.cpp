// The chart of trajectories: a gnuplot script with one column of panels a particle, one row a coordinate that changes,
// and below them how far each method is from the finest one, so that curves which overlap still tell something.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>

#include "study/charts/chart_pen.h"
#include "study/charts/gnuplot.h"
#include "study/charts/trajectory_distance.h"

namespace tyg {
namespace {

// In pixels of the PNG, and of the SVG before it is scaled.
constexpr double kColumnWidth = 1180, kSingleWidth = 1600, kPanelHeight = 270, kGap = 36;
constexpr double kLeft = 190, kRight = 50, kBottom = 140;
constexpr double kHead = 150, kLegendRow = 44, kSampleWidth = 120, kCharacterWidth = 11.5;

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
    const double start = run.ways[particle].front().*coordinate;
    for (const Vec3& at : run.ways[particle]) {
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

/// A rectangle of the figure for one row of panels; `coordinate` is empty for the distances.
struct Row {
  std::optional<std::size_t> coordinate;
};

class Script {
 public:
  explicit Script(const TrajectoryStudy& study) : study_(study) {
    for (std::size_t c = 0; c < kCoordinates.size(); ++c) {
      if (changes(c)) {
        rows_.push_back({c});
      } else {
        still_ += std::string(still_.empty() ? "" : " and ") + kNames.at(c);
      }
    }
    const bool compared = study.runs.size() > 1;
    for (std::size_t p = 0; compared && p < study.particles.size(); ++p)
      anyDistance_ |= !distanceRange(study, p).empty();
    if (anyDistance_) rows_.push_back({std::nullopt});
    width_ = study.particles.size() == 1 ? kSingleWidth : kColumnWidth * double(study.particles.size());
    const std::size_t legendRows = (study.runs.size() + legendColumns() - 1) / legendColumns();
    const double columnHeads = study.particles.size() > 1 ? 40 : 0;
    top_ = kHead + kLegendRow * double(legendRows) + columnHeads;
    height_ = top_ + kBottom + double(rows_.size()) * (kPanelHeight + kGap) - kGap;
  }

  std::string text() {
    out_.precision(12);  // an axis may be short and far from zero
    head();
    for (std::size_t row = 0; row < rows_.size(); ++row) {
      for (std::size_t p = 0; p < study_.particles.size(); ++p) panel(row, p);
    }
    endPictures(out_);
    return out_.str();
  }

 private:
  [[nodiscard]] bool changes(std::size_t c) const {
    for (std::size_t p = 0; p < study_.particles.size(); ++p) {
      const Range range = rangeOf(study_, p, kCoordinates.at(c));
      if (range.high > range.low) return true;
    }
    return false;
  }

  [[nodiscard]] std::string subtitle() const {
    const Scene& scene = study_.scene;
    std::ostringstream text;
    text << scene.columns << " x " << scene.rows << " particles, steps of " << scene.dt << " s";
    const auto isAdaptive = [](const Trajectory& run) { return run.method->adaptive; };
    if (std::ranges::any_of(study_.runs, isAdaptive)) text << " (adaptive ones: within " << scene.tolerance << " m)";
    if (!still_.empty()) text << "; " << still_ << (still_.size() > 1 ? " do" : " does") << " not change";
    return text.str();
  }

  [[nodiscard]] std::string title() const {
    std::string text = study_.scene.title + ": the way of ";
    if (study_.particles.size() > 1) return text + std::to_string(study_.particles.size()) + " particles";
    return text + "the " + study_.particles.front().label + " particle";
  }

  void head() {
    out_ << "# Draws plot.svg and plot.png from plot.csv:  gnuplot plot.gp\nset datafile separator comma\n";
    namePictures(out_, "plot");
    beginPictures(out_, width_, height_, 22);
    out_ << "  set grid lt 1 lc '#d0d0d0' lw 1\n  set xrange [0:" << study_.scene.duration << "]\n";
    label(title(), kLeft / width_, 1 - 45 / height_, "left", 1.35);
    label(subtitle(), kLeft / width_, 1 - 95 / height_, "left", 1.0, "#555555");
  }

  void label(const std::string& text, double x, double y, const char* where, double scale,
             const char* colour = "#000000") {
    out_ << "  set label " << gnuplotQuoted(text) << " at screen " << x << "," << y << " " << where
         << " font sprintf(',%g', (kind eq 'svg' ? 22 : 17) * " << scale << ") textcolor '" << colour
         << "' noenhanced\n";
  }

  void panel(std::size_t row, std::size_t p) {
    const double columnWidth = width_ / double(study_.particles.size());
    const double top = 1 - (top_ + double(row) * (kPanelHeight + kGap)) / height_;
    out_ << "  set lmargin at screen " << (double(p) * columnWidth + kLeft) / width_ << "\n  set rmargin at screen "
         << (double(p + 1) * columnWidth - kRight) / width_ << "\n  set tmargin at screen " << top
         << "\n  set bmargin at screen " << top - kPanelHeight / height_ << "\n";
    if (row == 0 && study_.particles.size() > 1) {
      label(study_.particles[p].label, (double(p) * columnWidth + kLeft) / width_, top + 22 / height_, "left", 1.0);
    }
    if (row + 1 == rows_.size()) {
      out_ << "  set xlabel 'time (s)'\n  set format x '%g'\n";
    } else {
      out_ << "  unset xlabel\n  set format x ''\n";
    }
    if (row == 0 && p == 0) legend();
    axis(rows_[row], p);
    curves(rows_[row], p);
    out_ << "  unset label\n  unset arrow\n";
  }

  void axis(const Row& row, std::size_t p) {
    if (row.coordinate) {
      const Range range = rangeOf(study_, p, kCoordinates.at(*row.coordinate));
      const bool failed =
          std::ranges::any_of(study_.runs, [](const Trajectory& run) { return run.status != Status::Ok; });
      const Range shown = range.widened(failed ? 0.3 : 0.08);
      out_ << "  unset logscale y\n  set format y '%g'\n  set ylabel '" << kNames.at(*row.coordinate) << " (m)'\n";
      shown.high > shown.low ? out_ << "  set yrange [" << shown.low << ":" << shown.high << "]\n"
                             : out_ << "  set yrange [*:*]\n";
      marks(*row.coordinate, p, shown);
      return;
    }
    const Range range = distanceRange(study_, p);
    out_ << "  set logscale y\n  set format y '10^{%T}'\n  set ylabel \"distance from\\n"
         << study_.runs[study_.finest].method->label << " (m)\"\n";
    if (range.empty()) {
      out_ << "  set yrange [*:*]\n";
      return;
    }
    // Whole decades, so that there are labelled tics; curves that cross dip without end and are cut four decades down.
    const double high = std::ceil(std::log10(1.1 * range.high));
    const double low = std::max(std::floor(std::log10(range.low)), high - 4);
    out_ << "  set yrange [1e" << low << ":1e" << high << "]\n";
  }

  /// A cross where a run that failed was last seen.
  void marks(std::size_t coordinate, std::size_t p, const Range& shown) {
    for (std::size_t k = 0; k < study_.runs.size(); ++k) {
      const Trajectory& run = study_.runs[k];
      if (run.status == Status::Ok) continue;
      const double last = run.ways[p].back().*kCoordinates.at(coordinate);
      out_ << "  set label '' at first " << run.times.back() << ","
           << (std::isfinite(last) ? std::clamp(last, shown.low, shown.high) : shown.high)
           << " point pt 2 ps 2.5 lw 4 lc '" << colour(k) << "' front\n";
    }
  }

  void curves(const Row& row, std::size_t p) {
    const int column = row.coordinate ? 4 + static_cast<int>(*row.coordinate) : 7;
    out_ << "  plot ";
    curve(study_.finest, p, column, "");
    for (std::size_t k = 0; k < study_.runs.size(); ++k) {
      if (k != study_.finest) curve(k, p, column, ", \\\n       ");
    }
    out_ << "\n";
  }

  void curve(std::size_t k, std::size_t p, int column, const char* before) {
    out_ << before << "'plot.csv' skip 1 using (strcol(1) eq '" << study_.runs[k].method->name << "' && strcol(2) eq "
         << gnuplotQuoted(study_.particles[p].label) << " ? $3 : NaN):" << column << " with lines " << style(k);
  }

  /// The finest run is a broad band below the others' dashes, so that curves on top of each other all show.
  [[nodiscard]] std::string style(std::size_t k) const {
    if (k == study_.finest) return "lw 9 dt 1 lc '" + colour(k) + "'";
    constexpr std::array kDashes{"(9,5)", "(3,3)", "(9,4,2,4)", "(16,5)"};
    return std::string("lw 4 dt ") + kDashes.at(k % kDashes.size()) + " lc '" + colour(k) + "'";
  }
  [[nodiscard]] std::string colour(std::size_t k) const { return k == study_.finest ? "#b0b0b0" : chartColour(k); }

  [[nodiscard]] std::string nameOfRun(std::size_t k) const {
    const Trajectory& run = study_.runs[k];
    std::ostringstream name;
    name << run.method->label;
    if (run.status != Status::Ok) name << " (" << nameOf(run.status) << " at " << run.failedAt << " s)";
    return name.str();
  }

  /// How many entries of the legend fit beside each other.
  [[nodiscard]] std::size_t legendColumns() const {
    std::size_t longest = 0;
    for (std::size_t k = 0; k < study_.runs.size(); ++k) longest = std::max(longest, nameOfRun(k).size());
    const double fit = (width_ - kLeft - kRight) / (kSampleWidth + kCharacterWidth * double(longest));
    return std::clamp<std::size_t>(static_cast<std::size_t>(fit), 1, study_.runs.size());
  }

  /// gnuplot's own key breaks its rows where it likes; this one keeps the order of the methods.
  void legend() {
    const std::size_t columns = legendColumns();
    const double entryWidth = (width_ - kLeft - kRight) / double(std::max<std::size_t>(columns, 3));
    for (std::size_t k = 0; k < study_.runs.size(); ++k) {
      const std::size_t row = k / columns;
      const double x = kLeft + entryWidth * double(k % columns);
      const double y = 1 - (kHead + kLegendRow * double(row)) / height_;
      out_ << "  set arrow from screen " << x / width_ << "," << y << " to screen " << (x + kSampleWidth - 30) / width_
           << "," << y << " nohead " << style(k) << "\n";
      label(nameOfRun(k), (x + kSampleWidth - 15) / width_, y, "left", 1.0);
    }
  }

  const TrajectoryStudy& study_;
  std::vector<Row> rows_;
  std::string still_;
  bool anyDistance_ = false;
  double width_ = 0, height_ = 0, top_ = 0;
  std::ostringstream out_;
};

}  // namespace

std::string trajectoryScript(const TrajectoryStudy& study) { return Script(study).text(); }

}  // namespace tyg

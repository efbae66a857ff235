// Layout and drawing of the plot. All lengths come from the size of the text, all places from the two axes.
#include "ui/panels/chart_plot.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "study/charts/method_style.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

constexpr float kSmall = 0.8F;       // of the text, for numbers at axes
constexpr float kStrip = 1.5F;       // text sizes, the height kept for runs that failed
constexpr float kReach = 0.7F;       // text sizes from the cursor to a point that it reads
constexpr float kMarkRadius = 0.2F;  // text sizes
constexpr double kRealTime = 1000;   // ms of computing per simulated second

bool shown(const WorkRow& row) { return row.status == RowStatus::Ok && row.rmsError > 0 && row.seconds > 0; }
bool failed(const WorkRow& row) { return row.status == RowStatus::Unstable || row.status == RowStatus::NotFinite; }

/// ms per simulated second; of a failed run, until it failed.
double costOf(const WorkRow& row, const ChartScale& scale) {
  return failed(row) ? 1e3 * row.seconds / (double(row.steps) * row.dt) : scale.cost(row.seconds);
}

/// A power of ten for an axis.
std::string decadeText(int decade) {
  const double value = std::pow(10.0, decade);
  return decade < -3 || decade > 4 ? fmt::format("{:.0e}", value) : fmt::format("{:g}", value);
}

/// Whole decades around what is to be shown.
class DecadeRange {
 public:
  void include(double value) {
    if (!(value > 0) || std::isinf(value)) return;
    low_ = std::min(low_, value), high_ = std::max(high_, value);
  }
  [[nodiscard]] bool empty() const { return high_ == 0; }
  [[nodiscard]] LogAxis axis() const {
    const double low = std::floor(std::log10(low_) - 0.1), high = std::ceil(std::log10(high_) + 0.1);
    return {std::pow(10.0, low), std::pow(10.0, high)};
  }

 private:
  double low_ = std::numeric_limits<double>::infinity(), high_ = 0;
};

/// Corners of a mark around the origin, radius 1; a circle has none.
std::array<ImVec2, 5> cornersOf(Mark mark, int& count) {
  switch (mark) {
    case Mark::TriangleUp:
      return count = 3, std::array<ImVec2, 5>{{{0, -1.2F}, {1.1F, 0.8F}, {-1.1F, 0.8F}}};
    case Mark::TriangleDown:
      return count = 3, std::array<ImVec2, 5>{{{0, 1.2F}, {-1.1F, -0.8F}, {1.1F, -0.8F}}};
    case Mark::Square:
      return count = 4, std::array<ImVec2, 5>{{{-0.9F, -0.9F}, {0.9F, -0.9F}, {0.9F, 0.9F}, {-0.9F, 0.9F}}};
    case Mark::Diamond:
      return count = 4, std::array<ImVec2, 5>{{{0, -1.3F}, {1.1F, 0}, {0, 1.3F}, {-1.1F, 0}}};
    case Mark::Pentagon:
      return count = 5,
             std::array<ImVec2, 5>{{{0, -1.2F}, {1.14F, -0.37F}, {0.7F, 0.97F}, {-0.7F, 0.97F}, {-1.14F, -0.37F}}};
    default:
      return count = 0, std::array<ImVec2, 5>{};
  }
}

void drawMark(ImDrawList& list, Mark mark, ImVec2 at, float radius, Colour colour) {
  int count = 0;
  std::array<ImVec2, 5> corners = cornersOf(mark, count);
  if (count == 0) return list.AddCircleFilled(at, radius, colour, 16);
  for (ImVec2& corner : corners) corner = {at.x + radius * corner.x, at.y + radius * corner.y};
  list.AddConvexPolyFilled(corners.data(), count, colour);
}

void drawCross(ImDrawList& list, ImVec2 at, float arm, Colour colour, float width) {
  list.AddLine({at.x - arm, at.y - arm}, {at.x + arm, at.y + arm}, colour, width);
  list.AddLine({at.x - arm, at.y + arm}, {at.x + arm, at.y - arm}, colour, width);
}

/// Of a run that failed: the method's mark, hollow, with a cross in it.
void drawFailedMark(ImDrawList& list, Mark mark, ImVec2 at, float radius, Colour colour) {
  int count = 0;
  std::array<ImVec2, 5> corners = cornersOf(mark, count);
  for (ImVec2& corner : corners) corner = {at.x + radius * corner.x, at.y + radius * corner.y};
  if (count == 0) {
    list.AddCircle(at, radius, colour, 16, 1.5F);
  } else {
    list.AddPolyline(corners.data(), count, colour, ImDrawFlags_Closed, 1.5F);
  }
  drawCross(list, at, 0.5F * radius, colour, 1.5F);
}

void drawLine(ImDrawList& list, ImVec2 from, ImVec2 to, Colour colour, float width, bool dashed) {
  if (!dashed) return list.AddLine(from, to, colour, width);
  constexpr float kDash = 5, kGap = 4;
  const float length = std::hypot(to.x - from.x, to.y - from.y);
  const auto point = [&](float along) {
    const float share = std::min(along, length) / length;
    return ImVec2{from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
  };
  const int dashes = int(std::ceil(length / (kDash + kGap)));
  for (int k = 0; k < dashes; ++k) {
    const float along = float(k) * (kDash + kGap);
    list.AddLine(point(along), point(along + kDash), colour, width);
  }
}

}  // namespace

/// Where things are on the screen, and what draws them.
struct ChartPlot::Layout {
  ImDrawList& list;
  const PanelScope& scope;
  const ChartScale& scale;
  LogAxis cost, error;
  float left = 0, right = 0, top = 0, bottom = 0;  ///< of the plot, pixels; the strip of failures is its upper part

  [[nodiscard]] float small() const { return kSmall * scope.size; }
  [[nodiscard]] float strip() const { return kStrip * scope.size; }
  [[nodiscard]] float x(double milliseconds) const {
    return left + float(cost.fractionAt(milliseconds)) * (right - left);
  }
  [[nodiscard]] float y(double millimetres) const {
    return bottom - float(error.fractionAt(millimetres)) * (bottom - top - strip());
  }
  /// Where a row is drawn; a failed one in the strip.
  [[nodiscard]] ImVec2 at(const WorkRow& row) const {
    if (!failed(row)) return {std::clamp(x(costOf(row, scale)), left, right), y(1e3 * row.rmsError)};
    return {std::clamp(x(costOf(row, scale)), left + strip() / 2, right - strip() / 2), top + strip() / 2};
  }
  [[nodiscard]] Colour colour(const MethodStyle& style) const { return seriesColour(style.colour, scope.background); }
  [[nodiscard]] ImVec2 extent(const char* text) const {
    return ImGui::GetFont()->CalcTextSizeA(small(), 1e6F, 0, text);
  }
  void text(ImVec2 where, Colour ink, const char* words) const {
    list.AddText(ImGui::GetFont(), small(), {std::round(where.x), std::round(where.y)}, ink, words);
  }
};

void ChartPlot::chooseAxes(const Contents& contents, const SettingEstimate& estimate) {
  DecadeRange costs, errors;
  for (const WorkRow& row : contents.rows) {
    if (!shown(row)) continue;
    costs.include(contents.scale.cost(row.seconds));
    errors.include(1e3 * row.rmsError);
  }
  costs.include(contents.scale.cost(estimate.seconds));
  errors.include(1e3 * estimate.error);
  if (costs.empty()) costs.include(1), costs.include(100);
  if (errors.empty()) errors.include(1e-6), errors.include(1e3 * contents.scale.size);
  cost_ = costs.axis();
  error_ = errors.axis();
}

namespace {

/// The power of ten of a number, within those that numbers have: a loop over decades ends whatever it is of.
double decadeOf(double number) {
  constexpr double kLowest = -330, kHighest = 310;
  const double decade = std::log10(number);
  return std::isnan(decade) ? 0 : std::clamp(decade, kLowest, kHighest);
}

/// First and last decade of an axis of whole decades.
std::pair<int, int> decadesOf(const LogAxis& axis) {
  return {int(std::lround(decadeOf(axis.low))), int(std::lround(decadeOf(axis.high)))};
}

}  // namespace

void ChartPlot::drawGrid(const Layout& layout) {
  const Colours& colours = layout.scope.colours;
  layout.list.AddRectFilled({layout.left, layout.top}, {layout.right, layout.bottom}, colours.field);
  layout.list.AddRectFilled({layout.left, layout.top}, {layout.right, layout.top + layout.strip()},
                            faded(colours.warning, 0.22F));
  constexpr const char* kFailed = "failed";
  layout.text({layout.left - layout.extent(kFailed).x - 0.4F * layout.small(),
               layout.top + 0.5F * (layout.strip() - layout.small())},
              colours.dim, kFailed);
  drawCostTicks(layout);
  drawErrorTicks(layout);
  if (layout.cost.low >= kRealTime || kRealTime >= layout.cost.high) return;
  const float x = layout.x(kRealTime);
  drawLine(layout.list, {x, layout.top}, {x, layout.bottom}, colours.dim, 1.5F, true);
  constexpr const char* kWords = "real time";
  const float width = layout.extent(kWords).x;
  layout.text({x - width - 4 > layout.left ? x - width - 4 : x + 4, layout.bottom - 1.2F * layout.small()}, colours.dim,
              kWords);
}

void ChartPlot::drawCostTicks(const Layout& layout) {
  const auto [first, last] = decadesOf(layout.cost);
  const int every = (layout.right - layout.left) / float(last - first) < 2.6F * layout.small() ? 2 : 1;
  for (int decade = first; decade <= last; ++decade) {
    const float x = layout.x(std::pow(10.0, decade));
    layout.list.AddLine({x, layout.top}, {x, layout.bottom}, faded(layout.scope.colours.dim, 0.25F));
    if ((decade - first) % every != 0) continue;
    const std::string text = decadeText(decade);
    layout.text({x - 0.5F * layout.extent(text.c_str()).x, layout.bottom + 0.2F * layout.small()},
                layout.scope.colours.dim, text.c_str());
  }
}

/// Millimetres at the left, fractions of the size at the right.
void ChartPlot::drawErrorTicks(const Layout& layout) {
  const Colour ink = layout.scope.colours.dim;
  const auto [first, last] = decadesOf(layout.error);
  const float perDecade = (layout.bottom - layout.top - layout.strip()) / float(last - first);
  const int every = std::max(1, int(std::ceil(1.4F * layout.small() / perDecade)));
  for (int decade = first; decade <= last; ++decade) {
    const float y = layout.y(std::pow(10.0, decade));
    layout.list.AddLine({layout.left, y}, {layout.right, y}, faded(ink, 0.25F));
    if ((decade - first) % every != 0) continue;
    const std::string text = decadeText(decade);
    layout.text({layout.left - layout.extent(text.c_str()).x - 0.4F * layout.small(), y - 0.5F * layout.small()}, ink,
                text.c_str());
  }
  const double size = 1e3 * layout.scale.size;  // mm
  const auto lowest = int(std::ceil(decadeOf(layout.error.low / size)));
  const auto highest = int(std::floor(decadeOf(layout.error.high / size)));
  for (int decade = lowest; decade <= highest; decade += every) {
    const float y = layout.y(size * std::pow(10.0, decade));
    const std::string text = decadeText(decade);
    layout.list.AddLine({layout.right, y}, {layout.right + 0.3F * layout.small(), y}, ink);
    layout.text({layout.right + 0.5F * layout.small(), y - 0.5F * layout.small()}, ink, text.c_str());
  }
}

void ChartPlot::drawCurves(const Layout& layout, const Contents& contents) const {
  const auto shareOf = [this](std::string_view method) {
    return emphasised_ == nullptr || emphasised_->name == method ? 1.0F : 0.2F;
  };
  // Of some methods alone it would be no frontier.
  const auto frontier = contents.allMethods ? frontierOf(contents.rows) : std::vector<const WorkRow*>();
  for (std::size_t k = 1; k < frontier.size(); ++k) {
    layout.list.AddLine(layout.at(*frontier[k - 1]), layout.at(*frontier[k]), faded(layout.scope.colours.good, 0.4F),
                        0.42F * layout.scope.size);
  }
  const WorkRow* before = nullptr;
  for (const WorkRow& row : contents.rows) {
    const MethodStyle style = styleOfMethod(row.integrator);
    const Colour colour = faded(layout.colour(style), shareOf(row.integrator));
    if (failed(row)) {
      drawFailedMark(layout.list, style.mark, layout.at(row), 1.3F * kMarkRadius * layout.scope.size, colour);
    }
    if (!shown(row)) continue;
    if (before != nullptr && before->integrator == row.integrator) {
      drawLine(layout.list, layout.at(*before), layout.at(row), colour, 1.5F, style.dashed);
    }
    before = &row;
    drawMark(layout.list, style.mark, layout.at(row), kMarkRadius * layout.scope.size, colour);
  }
}

void ChartPlot::drawPresent(const Layout& layout, const Contents& contents, const SettingEstimate& estimate) {
  if (estimate.kind == SettingEstimate::Kind::Unknown) return;
  const bool fails = estimate.kind == SettingEstimate::Kind::Fails;
  const ImVec2 at{fails ? layout.right - layout.strip() : layout.x(contents.scale.cost(estimate.seconds)),
                  fails ? layout.top + 0.5F * layout.strip() : layout.y(1e3 * estimate.error)};
  const float radius = 0.5F * layout.scope.size;
  const MethodStyle style = styleOfMethod(contents.present.method->name);
  drawMark(layout.list, style.mark, at, radius, layout.scope.colours.text);
  drawMark(layout.list, style.mark, at, 0.7F * radius, layout.colour(style));
  if (fails) drawCross(layout.list, at, 0.3F * radius, layout.scope.colours.field, 2);
}

const WorkRow* ChartPlot::nearest(const Layout& layout, const Contents& contents) {
  if (!ImGui::IsItemHovered()) return nullptr;
  const ImVec2 cursor = ImGui::GetMousePos();
  const WorkRow* found = nullptr;
  float least = kReach * layout.scope.size;
  for (const WorkRow& row : contents.rows) {
    if (!shown(row) && !failed(row)) continue;
    const ImVec2 at = layout.at(row);
    const float away = std::hypot(at.x - cursor.x, at.y - cursor.y);
    if (away < least) least = away, found = &row;
  }
  return found;
}

void ChartPlot::readOut(const Layout& layout, const WorkRow& row) {
  layout.list.AddCircle(layout.at(row), 0.45F * layout.scope.size, layout.scope.colours.text, 24, 2);
  ImGui::BeginTooltip();
  ImGui::TextUnformatted(row.integrator.c_str());
  ImGui::TextUnformatted(textOf(settingOf(row)).c_str());
  if (failed(row)) {
    ImGui::TextUnformatted(row.status == RowStatus::Unstable ? "became unstable" : "left the numbers");
  } else {
    ImGui::Text("error %s", errorText(row.rmsError, layout.scale).c_str());
    ImGui::TextUnformatted(costText(row.seconds, layout.scale).c_str());
    ImGui::TextUnformatted("click to use it");
  }
  ImGui::EndTooltip();
}

/// Marks and names in columns below the plot. The curve of a name under the cursor is highlighted in the plot.
void ChartPlot::legend(const PanelScope& scope, const Contents& contents) {
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, small = kSmall * scope.size, line = std::ceil(1.35F * small);
  std::vector<const Method*> charted;
  float widest = 0;
  for (const Method& method : methods()) {
    if (std::ranges::none_of(contents.rows, [&](const WorkRow& row) { return row.integrator == method.name; }))
      continue;
    charted.push_back(&method);
    const char* name = method.name.data();
    widest = std::max(widest, ImGui::GetFont()->CalcTextSizeA(small, 1e6F, 0, name, name + method.name.size()).x);
  }
  const float cell = widest + 2.2F * small;
  const auto columns = static_cast<std::size_t>(std::max(1.0F, std::floor(width / cell)));
  const ImVec2 cursor = ImGui::GetMousePos();
  emphasised_ = nullptr;
  for (std::size_t k = 0; k < charted.size(); ++k) {
    const Method& method = *charted[k];
    const std::size_t down = k / columns;
    const ImVec2 at{origin.x + float(k - down * columns) * cell, origin.y + float(down) * line};
    const bool under = ImGui::IsWindowHovered() && cursor.x >= at.x && cursor.x < at.x + cell && cursor.y >= at.y &&
                       cursor.y < at.y + line;
    if (under) emphasised_ = &method;
    if (under && scope.tips) ImGui::SetTooltip("%s", aboutMethod(method).c_str());
    const MethodStyle style = styleOfMethod(method.name);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    drawMark(list, style.mark, {at.x + 0.6F * small, at.y + 0.55F * small}, 1.2F * kMarkRadius * scope.size,
             seriesColour(style.colour, scope.background));
    const bool present = &method == contents.present.method;
    list.AddText(ImGui::GetFont(), small, {at.x + 1.4F * small, at.y},
                 under || present ? scope.colours.text : scope.colours.dim, method.name.data(),
                 method.name.data() + method.name.size());
  }
  const float height = line * std::ceil(float(charted.size()) / float(columns));
  ImGui::Dummy({width, std::ceil(std::max(height, line))});  // ImGui's windows fit whole pixels
}

const WorkRow* ChartPlot::draw(const PanelScope& scope, const Contents& contents, float height) {
  const SettingEstimate estimate = estimateOf(contents.rows, contents.present);
  chooseAxes(contents, estimate);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, small = kSmall * scope.size;
  ImGui::InvisibleButton("plot", {width, height});
  Layout layout{*ImGui::GetWindowDrawList(), scope, contents.scale, cost_, error_};
  const float numbers = std::max(layout.extent("1e-10").x, layout.extent("failed").x) + small;
  layout.left = origin.x + numbers, layout.right = origin.x + width - numbers;
  layout.top = origin.y + 1.5F * small, layout.bottom = origin.y + height - 2.8F * small;
  drawGrid(layout);
  layout.text({origin.x, origin.y}, scope.colours.text, "error, mm");
  constexpr const char *kRight = "of the sheet's size", *kBelow = "ms of computing per simulated second";
  layout.text({origin.x + width - layout.extent(kRight).x, origin.y}, scope.colours.text, kRight);
  layout.text({0.5F * (layout.left + layout.right - layout.extent(kBelow).x), layout.bottom + 1.5F * small},
              scope.colours.text, kBelow);
  const WorkRow* under = nearest(layout, contents);
  drawCurves(layout, contents);
  drawPresent(layout, contents, estimate);
  if (under != nullptr) readOut(layout, *under);
  legend(scope, contents);
  return under;
}

}  // namespace tyg

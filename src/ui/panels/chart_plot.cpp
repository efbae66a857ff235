// Layout and drawing of the plot. All lengths come from the size of the text, all places from the two axes.
#include "ui/panels/chart_plot.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "study/charts/method_look.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

constexpr float kSmall = 0.8F;       // of the text, for numbers at axes
constexpr float kStrip = 1.5F;       // text sizes, the height kept for runs that failed
constexpr float kReach = 0.7F;       // text sizes from the cursor to a point that it reads
constexpr float kMarkRadius = 0.2F;  // text sizes
constexpr double kRealTime = 1000;   // ms of computing per simulated second

using Text = std::array<char, 32>;

bool shown(const WorkRow& row) { return row.status == RowStatus::Ok && row.rmsError > 0 && row.seconds > 0; }
bool failed(const WorkRow& row) { return row.status == RowStatus::Unstable || row.status == RowStatus::NotFinite; }

/// ms per simulated second; of a failed run, until it failed.
double costOf(const WorkRow& row, const ChartScale& scale) {
  return failed(row) ? 1e3 * row.seconds / (double(row.steps) * row.dt) : scale.cost(row.seconds);
}

/// A power of ten for an axis.
Text decadeText(int decade) {
  Text text{};
  std::snprintf(text.data(), text.size(), decade < -3 || decade > 4 ? "%.0e" : "%g", std::pow(10.0, decade));
  return text;
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
struct ChartPlot::Pen {
  ImDrawList& list;
  const PanelScope& scope;
  const ChartScale& scale;
  LogAxis cost, error;
  float left = 0, right = 0, top = 0, bottom = 0;  ///< of the plot, pixels; the strip of failures is its upper part

  [[nodiscard]] float small() const { return kSmall * scope.size; }
  [[nodiscard]] float strip() const { return kStrip * scope.size; }
  [[nodiscard]] float x(double milliseconds) const { return left + float(cost.place(milliseconds)) * (right - left); }
  [[nodiscard]] float y(double millimetres) const {
    return bottom - float(error.place(millimetres)) * (bottom - top - strip());
  }
  /// Where a row stands; a failed one in the strip.
  [[nodiscard]] ImVec2 at(const WorkRow& row) const {
    const float across = std::clamp(x(costOf(row, scale)), left, right);
    return {across, failed(row) ? top + 0.5F * strip() : y(1e3 * row.rmsError)};
  }
  [[nodiscard]] Colour colour(const MethodLook& look) const { return seriesColour(look.colour, scope.background); }
  [[nodiscard]] ImVec2 extent(const char* text) const {
    return ImGui::GetFont()->CalcTextSizeA(small(), 1e6F, 0, text);
  }
  void text(ImVec2 where, Colour ink, const char* words) const {
    list.AddText(ImGui::GetFont(), small(), {std::round(where.x), std::round(where.y)}, ink, words);
  }
};

void ChartPlot::chooseAxes(const Contents& contents, const SettingPlace& place) {
  DecadeRange costs, errors;
  for (const WorkRow& row : contents.rows) {
    if (!shown(row)) continue;
    costs.include(contents.scale.cost(row.seconds));
    errors.include(1e3 * row.rmsError);
  }
  costs.include(contents.scale.cost(place.seconds));
  errors.include(1e3 * place.error);
  if (costs.empty()) costs.include(1), costs.include(100);
  if (errors.empty()) errors.include(1e-6), errors.include(1e3 * contents.scale.size);
  cost_ = costs.axis();
  error_ = errors.axis();
}

namespace {

/// First and last decade of an axis of whole decades.
std::pair<int, int> decadesOf(const LogAxis& axis) {
  return {int(std::lround(std::log10(axis.low))), int(std::lround(std::log10(axis.high)))};
}

}  // namespace

void ChartPlot::drawGrid(const Pen& pen) {
  const Colours& colours = pen.scope.colours;
  pen.list.AddRectFilled({pen.left, pen.top}, {pen.right, pen.bottom}, colours.field);
  pen.list.AddRectFilled({pen.left, pen.top}, {pen.right, pen.top + pen.strip()}, faded(colours.warning, 0.22F));
  constexpr const char* kFailed = "failed";
  pen.text({pen.left - pen.extent(kFailed).x - 0.4F * pen.small(), pen.top + 0.5F * (pen.strip() - pen.small())},
           colours.dim, kFailed);
  drawCostTicks(pen);
  drawErrorTicks(pen);
  if (pen.cost.low >= kRealTime || kRealTime >= pen.cost.high) return;
  const float x = pen.x(kRealTime);
  drawLine(pen.list, {x, pen.top}, {x, pen.bottom}, colours.dim, 1.5F, true);
  constexpr const char* kWords = "real time";
  const float width = pen.extent(kWords).x;
  pen.text({x - width - 4 > pen.left ? x - width - 4 : x + 4, pen.bottom - 1.2F * pen.small()}, colours.dim, kWords);
}

void ChartPlot::drawCostTicks(const Pen& pen) {
  const auto [first, last] = decadesOf(pen.cost);
  const int every = (pen.right - pen.left) / float(last - first) < 2.6F * pen.small() ? 2 : 1;
  for (int decade = first; decade <= last; ++decade) {
    const float x = pen.x(std::pow(10.0, decade));
    pen.list.AddLine({x, pen.top}, {x, pen.bottom}, faded(pen.scope.colours.dim, 0.25F));
    if ((decade - first) % every != 0) continue;
    const Text text = decadeText(decade);
    pen.text({x - 0.5F * pen.extent(text.data()).x, pen.bottom + 0.2F * pen.small()}, pen.scope.colours.dim,
             text.data());
  }
}

/// Millimetres at the left, fractions of the size at the right.
void ChartPlot::drawErrorTicks(const Pen& pen) {
  const Colour ink = pen.scope.colours.dim;
  const auto [first, last] = decadesOf(pen.error);
  const float perDecade = (pen.bottom - pen.top - pen.strip()) / float(last - first);
  const int every = std::max(1, int(std::ceil(1.4F * pen.small() / perDecade)));
  for (int decade = first; decade <= last; ++decade) {
    const float y = pen.y(std::pow(10.0, decade));
    pen.list.AddLine({pen.left, y}, {pen.right, y}, faded(ink, 0.25F));
    if ((decade - first) % every != 0) continue;
    const Text text = decadeText(decade);
    pen.text({pen.left - pen.extent(text.data()).x - 0.4F * pen.small(), y - 0.5F * pen.small()}, ink, text.data());
  }
  const double size = 1e3 * pen.scale.size;  // mm
  const auto lowest = int(std::ceil(std::log10(pen.error.low / size)));
  for (int decade = lowest; size * std::pow(10.0, decade) <= pen.error.high; decade += every) {
    const float y = pen.y(size * std::pow(10.0, decade));
    const Text text = decadeText(decade);
    pen.list.AddLine({pen.right, y}, {pen.right + 0.3F * pen.small(), y}, ink);
    pen.text({pen.right + 0.5F * pen.small(), y - 0.5F * pen.small()}, ink, text.data());
  }
}

void ChartPlot::drawCurves(const Pen& pen, const Contents& contents) const {
  const auto shareOf = [this](std::string_view method) {
    return emphasised_ == nullptr || emphasised_->name == method ? 1.0F : 0.2F;
  };
  // Of some methods alone it would be no frontier.
  const auto frontier = contents.allMethods ? frontierOf(contents.rows) : std::vector<const WorkRow*>();
  for (std::size_t k = 1; k < frontier.size(); ++k) {
    pen.list.AddLine(pen.at(*frontier[k - 1]), pen.at(*frontier[k]), faded(pen.scope.colours.good, 0.4F),
                     0.42F * pen.scope.size);
  }
  const WorkRow* before = nullptr;
  for (const WorkRow& row : contents.rows) {
    const MethodLook look = lookOfMethod(row.integrator);
    const Colour colour = faded(pen.colour(look), shareOf(row.integrator));
    if (failed(row)) {
      const ImVec2 at = pen.at(row);
      const float arm = kMarkRadius * pen.scope.size;
      pen.list.AddLine({at.x - arm, at.y - arm}, {at.x + arm, at.y + arm}, colour, 1.5F);
      pen.list.AddLine({at.x - arm, at.y + arm}, {at.x + arm, at.y - arm}, colour, 1.5F);
    }
    if (!shown(row)) continue;
    if (before != nullptr && before->integrator == row.integrator) {
      drawLine(pen.list, pen.at(*before), pen.at(row), colour, 1.5F, look.dashed);
    }
    before = &row;
    drawMark(pen.list, look.mark, pen.at(row), kMarkRadius * pen.scope.size, colour);
  }
}

void ChartPlot::drawPresent(const Pen& pen, const Contents& contents, const SettingPlace& place) {
  if (place.kind == SettingPlace::Kind::Unknown) return;
  const bool fails = place.kind == SettingPlace::Kind::Fails;
  const ImVec2 at{fails ? pen.right - pen.strip() : pen.x(contents.scale.cost(place.seconds)),
                  fails ? pen.top + 0.5F * pen.strip() : pen.y(1e3 * place.error)};
  const float radius = 0.5F * pen.scope.size;
  const MethodLook look = lookOfMethod(contents.present.method->name);
  pen.list.AddCircleFilled(at, radius, pen.scope.colours.text, 24);
  pen.list.AddCircleFilled(at, 0.72F * radius, pen.colour(look), 24);
  if (fails) {
    const float arm = 0.4F * radius;
    pen.list.AddLine({at.x - arm, at.y - arm}, {at.x + arm, at.y + arm}, pen.scope.colours.text, 2);
    pen.list.AddLine({at.x - arm, at.y + arm}, {at.x + arm, at.y - arm}, pen.scope.colours.text, 2);
  }
}

const WorkRow* ChartPlot::nearest(const Pen& pen, const Contents& contents) {
  if (!ImGui::IsItemHovered()) return nullptr;
  const ImVec2 cursor = ImGui::GetMousePos();
  const WorkRow* found = nullptr;
  float least = kReach * pen.scope.size;
  for (const WorkRow& row : contents.rows) {
    if (!shown(row) && !failed(row)) continue;
    const ImVec2 at = pen.at(row);
    const float away = std::hypot(at.x - cursor.x, at.y - cursor.y);
    if (away < least) least = away, found = &row;
  }
  return found;
}

void ChartPlot::readOut(const Pen& pen, const WorkRow& row) {
  pen.list.AddCircle(pen.at(row), 0.45F * pen.scope.size, pen.scope.colours.text, 24, 2);
  ImGui::BeginTooltip();
  ImGui::TextUnformatted(row.integrator.c_str());
  ImGui::TextUnformatted(textOf(settingOf(row)).c_str());
  if (failed(row)) {
    ImGui::TextUnformatted(row.status == RowStatus::Unstable ? "became unstable" : "left the numbers");
  } else {
    ImGui::Text("error %s", errorText(row.rmsError, pen.scale).c_str());
    ImGui::TextUnformatted(costText(row.seconds, pen.scale).c_str());
    ImGui::TextUnformatted("click to use it");
  }
  ImGui::EndTooltip();
}

/// Marks and names in columns below the plot. Names under the cursor stand out in the plot.
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
    const MethodLook look = lookOfMethod(method.name);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    drawMark(list, look.mark, {at.x + 0.6F * small, at.y + 0.55F * small}, 1.2F * kMarkRadius * scope.size,
             seriesColour(look.colour, scope.background));
    const bool present = &method == contents.present.method;
    list.AddText(ImGui::GetFont(), small, {at.x + 1.4F * small, at.y},
                 under || present ? scope.colours.text : scope.colours.dim, method.name.data(),
                 method.name.data() + method.name.size());
  }
  const float height = line * std::ceil(float(charted.size()) / float(columns));
  ImGui::Dummy({width, std::ceil(std::max(height, line))});  // ImGui's windows fit whole pixels
}

const WorkRow* ChartPlot::draw(const PanelScope& scope, const Contents& contents, float height) {
  const SettingPlace place = placeOf(contents.rows, contents.present);
  chooseAxes(contents, place);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, small = kSmall * scope.size;
  ImGui::InvisibleButton("plot", {width, height});
  Pen pen{*ImGui::GetWindowDrawList(), scope, contents.scale, cost_, error_};
  const float numbers = std::max(pen.extent("1e-10").x, pen.extent("failed").x) + small;
  pen.left = origin.x + numbers, pen.right = origin.x + width - numbers;
  pen.top = origin.y + 1.5F * small, pen.bottom = origin.y + height - 2.8F * small;
  drawGrid(pen);
  pen.text({origin.x, origin.y}, scope.colours.text, "error, mm");
  constexpr const char *kRight = "of the sheet's size", *kBelow = "ms of computing per simulated second";
  pen.text({origin.x + width - pen.extent(kRight).x, origin.y}, scope.colours.text, kRight);
  pen.text({0.5F * (pen.left + pen.right - pen.extent(kBelow).x), pen.bottom + 1.5F * small}, scope.colours.text,
           kBelow);
  const WorkRow* under = nearest(pen, contents);
  drawCurves(pen, contents);
  drawPresent(pen, contents, place);
  if (under != nullptr) readOut(pen, *under);
  legend(scope, contents);
  return under;
}

}  // namespace tyg

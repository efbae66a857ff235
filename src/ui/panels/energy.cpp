// Samples the ledger once a frame. While it is open the simulation follows what is dissipated, which changes no bit of
// the motion.
#include "ui/panels/energy.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "ui/panels/paragraph.h"
#include "ui/panels/running_plot.h"
#include "viewer/power_flow.h"
#include "viewer/viewer.h"

namespace tyg {
namespace {

constexpr double kWindow = 10;  // s, simulated
enum Channel : std::size_t { Kinetic, Elastic, Gravitational, Dissipated, Work, Drift, kChannels };
constexpr std::array<const char*, 5> kNames{"kinetic", "elastic", "gravitational", "dissipated", "work of pushes"};

class EnergyPanel final : public Panel {
 public:
  void follow(Viewer& viewer) override {
    if (viewer_ == nullptr) viewer.scenes().followLedger(true);
    viewer_ = &viewer;
    const double time = viewer.run().simulation().time(), newest = viewer.run().timeline().newest;
    series_.cut(newest);
    if (viewer.run().simulation().status() != Status::Ok || viewer.run().seeking()) return;
    ledger_ = viewer.run().ledger();
    if (newest < since_) since_ = time, before_ = ledger_.dissipated;
    ledger_.dissipated -= before_;
    const std::array<float, kChannels> values{float(ledger_.kinetic),       float(ledger_.elastic),
                                              float(ledger_.gravitational), float(ledger_.dissipated),
                                              float(ledger_.work),          float(ledger_.drift)};
    series_.add(time, values);
  }

  void close() override {
    if (viewer_ != nullptr) viewer_->scenes().followLedger(false);
    viewer_ = nullptr;
    series_.clear();
    since_ = kNever;
  }

  void draw(const PanelScope& scope) override {
    std::array<RunningCurve, kNames.size()> curves;
    for (std::size_t k = 0; k < curves.size(); ++k) {
      curves.at(k) = {.name = kNames.at(k), .channel = k, .colour = seriesColour(k, scope.background)};
    }
    runningPlot(scope, {"energy", "J", kPlotHeight * scope.size}, series_, curves);
    names(scope);
    const std::array drift{RunningCurve{.name = "drift", .channel = Drift, .colour = scope.colours.text, .scale = 100}};
    runningPlot(scope, {"drift of their sum", "% of the largest energy", kDriftHeight * scope.size, kLeastDrift},
                series_, drift);
    if (since_ == kNever) return paragraph("Nothing is counted while the cloth has failed.", scope.colours.dim);
    if (since_ > 0) paragraph(fmt::format("Dissipation and drift count from {:.2f} s.", since_), scope.colours.dim);
    bonds(scope);
  }

 private:
  static constexpr float kPlotHeight = 9, kDriftHeight = 4.5F, kGraphHeight = 8;  ///< text sizes
  static constexpr double kNever = std::numeric_limits<double>::infinity();
  static constexpr double kLeastDrift = 1e-9;   ///< %: below it is rounding
  static constexpr double kPowerSeconds = 0.2;  ///< long enough to read, short enough to see a push

  /// What is dissipated and the drift are known only for a cloth that is shown at a time when they were counted.
  [[nodiscard]] bool counted(const PanelScope& scope) const { return scope.viewer.run().shown().time() >= since_; }

  /// At the time that is shown; nothing where no sample tells it.
  [[nodiscard]] std::optional<PowerFlow> flow(const PanelScope& scope) const {
    if (series_.size() < 2 || !counted(scope)) return {};
    const std::size_t now = series_.at(scope.viewer.run().shown().time());
    const std::size_t before =
        std::min(series_.at(series_.time(now) - kPowerSeconds), now - std::min<std::size_t>(now, 1));
    const double seconds = series_.time(now) - series_.time(before);
    if (!(seconds > 0) || seconds > 3 * kPowerSeconds) return {};
    return powerBetween(ledgerAt(before), ledgerAt(now), seconds);
  }
  [[nodiscard]] Ledger ledgerAt(std::size_t k) const {
    Ledger ledger;
    ledger.kinetic = double(series_.value(k, Kinetic)), ledger.elastic = double(series_.value(k, Elastic));
    ledger.gravitational = double(series_.value(k, Gravitational));
    ledger.dissipated = double(series_.value(k, Dissipated)), ledger.work = double(series_.value(k, Work));
    return ledger;
  }

  void names(const PanelScope& scope) const {
    const std::array now{ledger_.kinetic, ledger_.elastic, ledger_.gravitational, ledger_.dissipated, ledger_.work};
    if (!ImGui::BeginTable("energies", 2, ImGuiTableFlags_SizingStretchSame)) return;
    for (std::size_t k = 0; k < kNames.size(); ++k) {
      ImGui::TableNextColumn();
      ImGui::PushStyleColor(ImGuiCol_Text, seriesColour(k, scope.background));
      if (k == Dissipated && !counted(scope)) {
        ImGui::Text("%s -", kNames.at(k));
      } else {
        ImGui::Text("%s %.3g J", kNames.at(k), now.at(k));
      }
      ImGui::PopStyleColor();
    }
    ImGui::TableNextColumn();
    if (counted(scope) && ledger_.scale > 0) ImGui::Text("drift %.2g %%", 100 * ledger_.drift);
    ImGui::EndTable();
  }

  /// The bond graph: two sources at the left, the masses in the middle, springs and dampers at the right.
  void bonds(const PanelScope& scope) {
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = std::ceil(kGraphHeight * scope.size);
    ImGui::Dummy({width, height});
    const std::optional<PowerFlow> known = flow(scope);
    const PowerFlow flow = known.value_or(PowerFlow{});
    most_ = std::max({std::abs(flow.gravity), std::abs(flow.pushes), std::abs(flow.springs), std::abs(flow.dampers),
                      0.98 * most_, std::numeric_limits<double>::min()});
    const float half = 2.6F * scope.size;
    const ImVec2 masses{origin.x + width / 2, origin.y + height / 2};
    const auto at = [&](bool right, bool low) {
      return ImVec2{right ? origin.x + width - half : origin.x + half, origin.y + (low ? 0.82F : 0.18F) * height};
    };
    const bool told = known.has_value();
    bond(scope, at(false, false), masses, {flow.gravity, true, told});
    bond(scope, at(false, true), masses, {flow.pushes, false, told});
    bond(scope, masses, at(true, false), {flow.springs, true, told});
    bond(scope, masses, at(true, true), {flow.dampers, false, told});
    node(scope, at(false, false), half, "gravity", scope.colours.dim);
    node(scope, at(false, true), half, "pushes", seriesColour(Work, scope.background));
    node(scope, at(true, false), half, "springs", seriesColour(Elastic, scope.background));
    node(scope, at(true, true), half, "dampers", seriesColour(Dissipated, scope.background));
    node(scope, masses, half, "masses", seriesColour(Kinetic, scope.background));
  }

  static void node(const PanelScope& scope, ImVec2 middle, float half, const char* name, Colour colour) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float tall = 0.85F * scope.size;
    const ImVec2 low{middle.x - half, middle.y - tall}, high{middle.x + half, middle.y + tall};
    list.AddRectFilled(low, high, scope.colours.field, 0.4F * scope.size);
    list.AddRect(low, high, colour, 0.4F * scope.size, 0, 2);
    const ImVec2 extent = ImGui::CalcTextSize(name);
    list.AddText({middle.x - extent.x / 2, middle.y - extent.y / 2}, scope.colours.text, name);
  }

  struct Power {
    double watts = 0;
    bool above = false;  ///< the bond: that is where its number is written
    bool known = true;
  };
  /// A line as wide as the power is great, with its head where the power goes and its number at the middle.
  void bond(const PanelScope& scope, ImVec2 from, ImVec2 to, const Power& power) const {
    const double watts = power.watts;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float share = float(std::abs(watts) / most_), thick = 1 + 0.5F * scope.size * std::min(share, 1.0F);
    const bool still = share < 1e-3F;
    const Colour colour = still ? faded(scope.colours.dim, 0.5F) : scope.colours.accent;
    list.AddLine(from, to, colour, thick);
    const ImVec2 middle{(from.x + to.x) / 2, (from.y + to.y) / 2};
    if (!still) {
      const float length = std::hypot(to.x - from.x, to.y - from.y), sign = watts > 0 ? 1.0F : -1.0F;
      const ImVec2 way{sign * (to.x - from.x) / length, sign * (to.y - from.y) / length};
      const float head = 0.5F * scope.size + thick / 2;
      list.AddTriangleFilled({middle.x + head * way.x, middle.y + head * way.y},
                             {middle.x - head * (way.x - way.y) / 2, middle.y - head * (way.y + way.x) / 2},
                             {middle.x - head * (way.x + way.y) / 2, middle.y - head * (way.y - way.x) / 2}, colour);
    }
    const std::string text = power.known ? fmt::format("{:.2g} W", std::abs(watts)) : "- W";
    const float small = 0.85F * scope.size;
    const float extent = ImGui::GetFont()->CalcTextSizeA(small, 1e6F, 0, text.c_str()).x;
    list.AddText(ImGui::GetFont(), small,
                 {middle.x - extent / 2, middle.y + (power.above ? -1.85F : 0.95F) * scope.size},
                 still ? scope.colours.dim : scope.colours.text, text.c_str());
  }

  Viewer* viewer_ = nullptr;  ///< whose ledger is being followed
  RunningSeries series_{kChannels, kWindow};
  Ledger ledger_;          ///< with what was dissipated since then:
  double since_ = kNever;  ///< s
  double before_ = 0;      ///< J, dissipated until then as the simulation counts
  double most_ = 0;        ///< W, the widest bond
};

}  // namespace

std::unique_ptr<Panel> makeEnergyPanel() { return std::make_unique<EnergyPanel>(); }

}  // namespace tyg

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
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/forces/term.h"
#include "core/forces/terms/all_terms.h"
#include "ui/panels/paragraph.h"
#include "ui/panels/running_plot.h"
#include "viewer/power_flow.h"
#include "viewer/viewer.h"

namespace tyg {
namespace {

constexpr double kWindow = 10;  // s, simulated
/// The channels of the samples; what is stored and the work done have one for each entry of a ledger.
enum Channel : std::size_t { Kinetic, Dissipated, Drift, Stored, Work = Stored + Energies::kMost };
constexpr std::size_t kChannels = Work + Energies::kMost;

/// One of the energies that are plotted and named.
struct Amount {
  std::string name;
  std::string_view holder;  ///< what has it, or does it: named in the bond graph
  std::size_t channel = 0;
  double joules = 0;
  std::size_t colour = 0;  ///< as seriesColour() counts: an energy has the same one in every scene
};
/// Every kind of work that a ledger has named so far, in the order of their channels: one that is named later, as where
/// somebody adds a wind, comes after the others.
using WorkNames = std::vector<std::string_view>;
void addNames(const Ledger& ledger, WorkNames& names) {
  for (const Energies::Entry& entry : ledger.work) {
    if (std::ranges::find(names, entry.name) == names.end()) names.push_back(entry.name);
  }
}

/// Among all kinds of work that there are: by pushes, by what terms bring, and by pins.
std::size_t slotOfWork(std::string_view name) {
  if (name == "pushes") return 0;
  return 1 + static_cast<std::size_t>(std::ranges::find(kSupplies, name) - kSupplies.begin());
}

std::vector<Amount> amountsOf(const Ledger& ledger, const WorkNames& names) {
  std::vector<Amount> amounts{{"kinetic", "masses", Kinetic, ledger.kinetic, 0}};
  std::size_t channel = Stored, colour = 1;
  for (const EnergyStore& store : energyStores()) {
    if (ledger.stored.has(store.name)) {
      amounts.push_back({std::string(store.name), store.holder, channel, ledger.stored[store.name], colour});
    }
    ++channel, ++colour;
  }
  amounts.push_back({"dissipated", "dampers", Dissipated, ledger.dissipated, colour++});
  channel = Work;
  for (const std::string_view name : names) {
    amounts.push_back({fmt::format("work of {}", name), name, channel++, ledger.work[name], colour + slotOfWork(name)});
  }
  return amounts;
}

class EnergyPanel final : public Panel {
 public:
  void follow(Viewer& viewer) override {
    if (viewer_ == nullptr) viewer.scenes().followLedger(true);
    viewer_ = &viewer;
    const double time = viewer.run().simulation().time(), newest = viewer.run().timeline().newest;
    series_.cut(newest);
    if (viewer.run().simulation().status() != Status::Ok || viewer.run().seeking()) return;
    ledger_ = viewer.run().ledger();
    const bool begins = newest < since_;
    if (begins) since_ = time, before_ = ledger_.dissipated;
    ledger_.dissipated -= before_;
    std::array<float, kChannels> values{};
    if (series_.size() <= 1) works_.clear();  // a run that begins
    addNames(ledger_, works_);
    for (const Amount& amount : amountsOf(ledger_, works_)) values.at(amount.channel) = float(amount.joules);
    if (begins) zero_ = values;
    values[Drift] = float(ledger_.drift);
    series_.add(time, values);
  }

  void close() override {
    if (viewer_ != nullptr) viewer_->scenes().followLedger(false);
    viewer_ = nullptr;
    series_.clear();
    works_.clear();
    since_ = kNever;
  }

  void draw(const PanelScope& scope) override {
    const std::vector<Amount> amounts = amountsOf(ledger_, works_);
    std::vector<RunningCurve> curves;
    curves.reserve(amounts.size());
    for (const Amount& amount : amounts) {
      const Colour colour = seriesColour(amount.colour, scope.background);
      curves.push_back(
          {.name = amount.name, .channel = amount.channel, .colour = colour, .zero = zero_.at(amount.channel)});
    }
    runningPlot(scope, {"change of energy", "J", kPlotHeight * scope.size}, series_, curves);
    names(scope, amounts);
    const std::array drift{RunningCurve{.name = "drift", .channel = Drift, .colour = scope.colours.text, .scale = 100}};
    runningPlot(scope, {"drift of their sum", "% of the largest energy", kDriftHeight * scope.size, kLeastDrift},
                series_, drift);
    if (since_ == kNever) return paragraph("Nothing is counted while the cloth has failed.", scope.colours.dim);
    if (since_ > 0)
      paragraph(fmt::format("Changes, dissipation and drift: counted since {:.2f} s", since_), scope.colours.dim);
    bonds(scope, amounts);
  }

 private:
  static constexpr float kPlotHeight = 9, kDriftHeight = 4.5F, kGraphHeight = 8, kNodeHeight = 2.5F;  ///< text sizes
  static constexpr double kNever = std::numeric_limits<double>::infinity();
  static constexpr double kRounding = 1e-15;    ///< of the largest energy, or of 1 J: what is less is none
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
    const auto value = [&](std::size_t channel) { return double(series_.value(k, channel)); };
    Ledger ledger{.kinetic = value(Kinetic), .dissipated = value(Dissipated)};
    std::size_t channel = Stored;
    for (const EnergyStore& store : energyStores()) {
      if (ledger_.stored.has(store.name)) ledger.stored.add(store.name, value(channel));
      ++channel;
    }
    channel = Work;
    for (const std::string_view name : works_) ledger.work.add(name, value(channel++));
    return ledger;
  }

  void names(const PanelScope& scope, std::span<const Amount> amounts) const {
    if (!ImGui::BeginTable("energies", 2, ImGuiTableFlags_SizingStretchSame)) return;
    for (const Amount& amount : amounts) {
      ImGui::TableNextColumn();
      ImGui::PushStyleColor(ImGuiCol_Text, seriesColour(amount.colour, scope.background));
      if (amount.channel == Dissipated && !counted(scope)) {
        ImGui::Text("%s -", amount.name.c_str());
      } else {
        const bool isRounding = std::abs(amount.joules) < kRounding * std::max(1.0, ledger_.scale);
        ImGui::Text("%s %.3g J", amount.name.c_str(), isRounding ? 0 : amount.joules);
      }
      ImGui::PopStyleColor();
    }
    ImGui::TableNextColumn();
    if (counted(scope) && ledger_.scale > 0) ImGui::Text("drift %.2g %%", 100 * ledger_.drift);
    ImGui::EndTable();
  }

  /// The bond graph: sources at the left, the masses in the middle, springs and dampers at the right.
  void bonds(const PanelScope& scope, std::span<const Amount> amounts) {
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const std::optional<PowerFlow> known = flow(scope);
    const PowerFlow flow = known.value_or(powerBetween(ledger_, ledger_, 1));
    const std::size_t nodes = std::max(flow.sources().size(), flow.sinks().size());
    const float tallest = std::max(kGraphHeight, kNodeHeight * float(nodes));
    const float width = ImGui::GetContentRegionAvail().x, height = std::ceil(tallest * scope.size);
    ImGui::Dummy({width, height});
    most_ = std::max(0.98 * most_, std::numeric_limits<double>::min());
    for (const std::span<const PowerFlow::Bond> side : {flow.sources(), flow.sinks()}) {
      for (const PowerFlow::Bond& each : side) most_ = std::max(most_, std::abs(each.watts));
    }
    const float half = 2.6F * scope.size;
    const ImVec2 masses{origin.x + width / 2, origin.y + height / 2};
    // Bodies store energy at the right, and do work at the left.
    const auto named = [&](ImVec2 middle, std::string_view name, bool driving) {
      const auto is = [&](const Amount& amount) {
        return amount.holder == name && (!driving || amount.channel >= Work || !doesWork(amounts, name));
      };
      const auto amount = std::ranges::find_if(amounts, is);
      node(scope, middle, half, *amount, seriesColour(amount->colour, scope.background));
    };
    const auto draw = [&](std::span<const PowerFlow::Bond> side, bool driving) {
      for (std::size_t k = 0; k < side.size(); ++k) {
        const float edge = 0.72F * kNodeHeight / 2 * scope.size / height;
        const float share = side.size() > 1 ? edge + (1 - 2 * edge) * float(k) / float(side.size() - 1) : 0.5F;
        const ImVec2 at{driving ? origin.x + half : origin.x + width - half, origin.y + share * height};
        const Power power{side[k].watts, share < 0.5F, known.has_value()};
        driving ? bond(scope, at, masses, power) : bond(scope, masses, at, power);
        number(scope, at, masses, half, power);
        named(at, side[k].name, driving);
      }
    };
    draw(flow.sources(), true);
    draw(flow.sinks(), false);
    named(masses, "masses", false);
  }

  static bool doesWork(std::span<const Amount> amounts, std::string_view name) {
    return std::ranges::any_of(amounts,
                               [&](const Amount& amount) { return amount.holder == name && amount.channel >= Work; });
  }

  /// A box with what has this energy, in the colour of the energy's curve.
  static void node(const PanelScope& scope, ImVec2 middle, float half, const Amount& amount, Colour colour) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float tall = 0.85F * scope.size;
    const ImVec2 low{middle.x - half, middle.y - tall}, high{middle.x + half, middle.y + tall};
    list.AddRectFilled(low, high, scope.colours.field, 0.4F * scope.size);
    list.AddRect(low, high, colour, 0.4F * scope.size, 0, 2);
    const std::string name(amount.holder);
    const ImVec2 extent = ImGui::CalcTextSize(name.c_str());
    list.AddText({middle.x - extent.x / 2, middle.y - extent.y / 2}, scope.colours.text, name.c_str());
  }

  struct Power {
    double watts = 0;
    bool above = false;  ///< the bond: that is where its number is written
    bool known = true;
  };
  [[nodiscard]] bool isStill(const Power& power) const { return std::abs(power.watts) < 1e-3 * most_; }
  [[nodiscard]] float thickness(const PanelScope& scope, const Power& power) const {
    return 1 + 0.5F * scope.size * std::min(float(std::abs(power.watts) / most_), 1.0F);
  }
  /// A line as wide as the power is great, with its head where the power goes.
  void bond(const PanelScope& scope, ImVec2 from, ImVec2 to, const Power& power) const {
    const double watts = power.watts;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float thick = thickness(scope, power);
    const bool still = isStill(power);
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
  }
  /// Beside the box at the outer end, where lines to many boxes lie farthest apart, and clear of its own line.
  void number(const PanelScope& scope, ImVec2 outer, ImVec2 masses, float half, const Power& power) const {
    const double watts = std::abs(power.watts);
    const bool isWhole = watts >= 10 && watts < 1e5;  // two digits would be written as a power of ten
    const std::string known = isWhole ? fmt::format("{:.0f} W", watts) : fmt::format("{:.2g} W", watts);
    const std::string text = power.known ? known : "- W";
    const float small = 0.85F * scope.size;
    const float extent = ImGui::GetFont()->CalcTextSizeA(small, 1e6F, 0, text.c_str()).x;
    const float sign = outer.x < masses.x ? 1.0F : -1.0F, beside = half + 0.3F * scope.size + extent / 2;
    const float slope = (masses.y - outer.y) / std::abs(masses.x - outer.x);
    const ImVec2 at{outer.x + sign * beside, outer.y + slope * beside};
    const float clear = (thickness(scope, power) + std::abs(slope) * extent) / 2;
    const float y = power.above ? at.y - clear - small : at.y + clear;
    ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), small, {at.x - extent / 2, y},
                                        isStill(power) ? scope.colours.dim : scope.colours.text, text.c_str());
  }

  Viewer* viewer_ = nullptr;  ///< whose ledger is being followed
  RunningSeries series_{kChannels, kWindow};
  WorkNames works_;
  Ledger ledger_;                        ///< with what was dissipated since then:
  double since_ = kNever;                ///< s
  double before_ = 0;                    ///< J, dissipated until then as the simulation counts
  std::array<float, kChannels> zero_{};  ///< J, of each channel then
  double most_ = 0;                      ///< W, the widest bond
};

}  // namespace

std::unique_ptr<Panel> makeEnergyPanel() { return std::make_unique<EnergyPanel>(); }

}  // namespace tyg

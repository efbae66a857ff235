// See traces.h.
#include "app/panels/traces.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "app/panels/running_plot.h"
#include "app/viewer.h"

namespace tyg {
namespace {

constexpr std::size_t kMost = 4;
constexpr double kWindow = 5;  // s, simulated
constexpr std::array<const char*, 5> kNamed{"bottom-left", "bottom-right", "middle", "top-left", "top-right"};

class TracesPanel final : public Panel {
 public:
  void follow(Viewer& viewer) override {
    if (sheet_ != viewer.sheetsSoFar()) {
      sheet_ = viewer.sheetsSoFar();
      particles_ = {particleAt(viewer.simulation().sheet(), Place{.name = "bottom-left"})};
      series_.clear();
    }
    std::array<float, 3 * kMost> values{};
    const std::span<const float> xyz = viewer.positions();
    for (std::size_t k = 0; k < particles_.size(); ++k) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        values.at(3 * k + axis) = xyz[3 * static_cast<std::size_t>(particles_[k]) + axis];
      }
    }
    series_.add(viewer.time(), values);
  }

  void draw(const PanelScope& scope) override {
    constexpr std::array kTitles{"x, m", "y, m", "z, m"};
    for (std::size_t axis = 0; axis < kTitles.size(); ++axis) {
      std::array<RunningCurve, kMost> curves;
      for (std::size_t k = 0; k < particles_.size(); ++k) {
        curves.at(k) = {.channel = 3 * k + axis, .colour = seriesColour(k, scope.background)};
      }
      runningPlot(scope, kTitles.at(axis), series_, std::span(curves).first(particles_.size()), kHeight * scope.size);
    }
    list(scope);
    add(scope.viewer);
  }

 private:
  static constexpr float kHeight = 6;  ///< text sizes, of each plot

  /// The particles in their curves' colours; a click takes one away.
  void list(const PanelScope& scope) {
    const int columns = scope.viewer.simulation().sheet().columns;
    for (std::size_t k = 0; k < particles_.size(); ++k) {
      std::array<char, 64> text{};
      std::snprintf(text.data(), text.size(), "[%d, %d] x##%d", particles_[k] % columns, particles_[k] / columns,
                    particles_[k]);
      ImGui::PushStyleColor(ImGuiCol_Text, seriesColour(k, scope.background));
      const bool gone = ImGui::SmallButton(text.data());
      ImGui::PopStyleColor();
      if (k + 1 < particles_.size()) ImGui::SameLine();
      if (!gone) continue;
      particles_.erase(particles_.begin() + static_cast<std::ptrdiff_t>(k));
      return series_.clear();
    }
  }

  void add(const Viewer& viewer) {
    if (particles_.size() == kMost) return;
    ImGui::SetNextItemWidth(-1);
    if (!ImGui::BeginCombo("##add", "add a particle")) return;
    const Sheet& sheet = viewer.simulation().sheet();
    const int pushed = viewer.picked();
    if (pushed >= 0 && ImGui::Selectable("the one pushed last")) addOne(pushed);
    for (const char* name : kNamed) {
      if (ImGui::Selectable(name)) addOne(particleAt(sheet, Place{.name = name}));
    }
    ImGui::EndCombo();
  }
  void addOne(int particle) {
    if (std::ranges::find(particles_, particle) != particles_.end()) return;
    particles_.push_back(particle);
    series_.clear();
  }

  int sheet_ = 0;  ///< which of the viewer's sheets the particles are of
  std::vector<int> particles_;
  RunningSeries series_{3 * kMost, kWindow};
};

}  // namespace

std::unique_ptr<Panel> makeTracesPanel() { return std::make_unique<TracesPanel>(); }

}  // namespace tyg

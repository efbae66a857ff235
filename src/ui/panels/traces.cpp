// Samples the particles that are followed once a frame, three channels for each.
#include "ui/panels/traces.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "ui/panels/running_plot.h"
#include "view/picking.h"
#include "viewer/viewer.h"

namespace tyg {
namespace {

constexpr std::size_t kMost = 4;
constexpr double kWindow = 5;  // s, simulated
constexpr std::array<const char*, 5> kNamed{"bottom-left", "bottom-right", "middle", "top-left", "top-right"};

class TracesPanel final : public Panel {
 public:
  void follow(Viewer& viewer) override {
    if (sheet_ != viewer.scenes().sheetsSoFar()) {
      sheet_ = viewer.scenes().sheetsSoFar();
      particles_ = {};
      particles_[0] = firstOne(viewer.run().simulation().sheet());
      series_.clear();
    }
    std::array<float, 3 * kMost> values{};
    const std::span<const float> xyz = viewer.run().shown().positions();
    for (std::size_t k = 0; k < kMost; ++k) {
      for (std::size_t axis = 0; particles_.at(k) && axis < 3; ++axis) {
        values.at(3 * k + axis) = xyz[3 * static_cast<std::size_t>(*particles_.at(k)) + axis];
      }
    }
    series_.cut(viewer.run().timeline().newest);
    series_.add(viewer.run().shown().time(), values);
  }

  void close() override {
    series_.clear();
    picking_ = false;
  }

  /// The next click on a particle takes it, and is no push.
  bool handle(const WindowEvent& event, Viewer& viewer) override {
    if (!picking_ || event.kind != WindowEvent::Kind::Press || event.key != kLeftButton) return false;
    const std::optional<int> hit = pickParticle(viewer.view().camera(), {event.x, event.y}, framebuffer(),
                                                viewer.run().simulation().sheet(), viewer.run().shown().positions());
    if (!hit) return viewer.notes().say("There is no particle."), true;
    addOne(*hit);
    picking_ = false;
    return true;
  }

  void draw(const PanelScope& scope) override {
    constexpr std::array kTitles{"x", "y", "z"};
    constexpr double kLeast = 1e-6;  // of the sheet's size
    const double least = kLeast * scope.viewer.run().simulation().sheet().size();
    std::vector<RunningCurve> curves;
    for (std::size_t k = 0; k < kMost; ++k) {
      if (!particles_.at(k)) continue;
      curves.push_back({.name = nameOf(*particles_.at(k), scope.viewer),
                        .channel = 3 * k,
                        .colour = seriesColour(k, scope.background)});
    }
    for (const char* title : kTitles) {
      runningPlot(scope, {title, "m", kHeight * scope.size, least}, series_, curves);
      for (RunningCurve& curve : curves) ++curve.channel;  // the next axis
    }
    list(scope);
    add(scope.viewer);
    mark(scope);
  }

 private:
  static constexpr float kHeight = 6;  ///< text sizes, of each plot

  /// The first of the named ones that is free to move.
  static int firstOne(const Sheet& sheet) {
    for (const char* name : {"bottom-left", "bottom-right", "middle", "top-left", "top-right"}) {
      const int particle = particleAt(sheet, Place{.name = name});
      if (!std::ranges::binary_search(sheet.pins, particle)) return particle;
    }
    return 0;
  }
  static std::string nameOf(int particle, const Viewer& viewer) {
    const int columns = viewer.run().simulation().sheet().columns;
    return fmt::format("[{}, {}]", particle % columns, particle / columns);
  }
  /// In whose pixels the positions of events are.
  static glm::vec2 framebuffer() {
    const ImGuiIO& io = ImGui::GetIO();
    return {io.DisplaySize.x * io.DisplayFramebufferScale.x, io.DisplaySize.y * io.DisplayFramebufferScale.y};
  }

  /// The particles in their curves' colours; a click takes one away.
  void list(const PanelScope& scope) {
    ImGui::TextDisabled("[column, row]");
    for (std::size_t k = 0; k < kMost; ++k) {
      if (!particles_.at(k)) continue;
      ImGui::SameLine();
      ImGui::PushID(static_cast<int>(k));
      ImGui::PushStyleColor(ImGuiCol_Text, seriesColour(k, scope.background));
      const bool gone = ImGui::SmallButton((nameOf(*particles_.at(k), scope.viewer) + " \u00d7").c_str());
      ImGui::PopStyleColor();
      ImGui::PopID();
      if (gone) particles_.at(k).reset();
    }
  }

  void add(const Viewer& viewer) {
    if (std::ranges::all_of(particles_, [](const auto& particle) { return particle.has_value(); })) return;
    if (ImGui::Button(picking_ ? "click a particle ..." : "pick one on the cloth")) picking_ = !picking_;
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    if (!ImGui::BeginCombo("##add", "add")) return;
    const Sheet& sheet = viewer.run().simulation().sheet();
    const int pushed = viewer.tools().record().picked;
    if (pushed >= 0 && ImGui::Selectable("the one pushed last")) addOne(pushed);
    for (const char* name : kNamed) {
      if (ImGui::Selectable(name)) addOne(particleAt(sheet, Place{.name = name}));
    }
    ImGui::EndCombo();
  }
  void addOne(int particle) {
    if (std::ranges::find(particles_, particle) != particles_.end()) return;
    const auto free = std::ranges::find(particles_, std::optional<int>{});
    if (free == particles_.end()) return;
    *free = particle;
    const auto slot = static_cast<std::size_t>(free - particles_.begin());
    for (std::size_t axis = 0; axis < 3; ++axis) series_.forget(3 * slot + axis);
  }

  /// A ring around each particle, in the colour of its curves.
  void mark(const PanelScope& scope) const {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const Camera& camera = scope.viewer.view().camera();
    const glm::mat4 seen = camera.projection(screen.x / std::max(screen.y, 1.0F)) * camera.view();
    for (std::size_t k = 0; k < kMost; ++k) {
      if (!particles_.at(k)) continue;
      const float* at = &scope.viewer.run().shown().positions()[3 * static_cast<std::size_t>(*particles_.at(k))];
      const glm::vec4 clip = seen * glm::vec4(at[0], at[1], at[2], 1);
      if (!(clip.w > 0)) continue;
      const ImVec2 middle{0.5F * (1 + clip.x / clip.w) * screen.x, 0.5F * (1 - clip.y / clip.w) * screen.y};
      ImGui::GetBackgroundDrawList()->AddCircle(middle, 0.45F * scope.size, seriesColour(k, scope.background), 20,
                                                2.5F);
    }
  }

  int sheet_ = 0;  ///< which of the viewer's sheets the particles are of
  std::array<std::optional<int>, kMost> particles_;
  bool picking_ = false;
  RunningSeries series_{3 * kMost, kWindow};
};

}  // namespace

std::unique_ptr<Panel> makeTracesPanel() { return std::make_unique<TracesPanel>(); }

}  // namespace tyg

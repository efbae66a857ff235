// Measures the stretch of the springs that are shown, once a frame.
#include "ui/panels/stretch.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/forces/terms/springs.h"
#include "ui/panels/colour_bar.h"
#include "ui/panels/paragraph.h"
#include "view/stretch.h"
#include "viewer/viewer.h"

namespace tyg {
namespace {

constexpr std::array kNames{"structural", "shear", "bend"};

class StretchPanel final : public Panel {
 public:
  void follow(Viewer& viewer) override {
    const Simulation& simulation = viewer.run().simulation();
    double most = 0, typical = 0;
    for (std::size_t k = 0; k < kFamilies.size(); ++k) {
      stretches_.at(k) = {};
      if (!familyOf(simulation.scene(), kFamilies.at(k)).present()) continue;
      stretches_.at(k) = stretchOf(simulation.sheet(), viewer.run().shown().positions(), kFamilies.at(k));
      most = std::max({most, stretches_.at(k).largest, -stretches_.at(k).smallest});
      typical = std::max(typical, stretches_.at(k).rms);
    }
    // A few springs at a pin would leave all others grey.
    top_ = steadyTop(top_, std::max(std::min(most, 2 * typical), kLeastTop));
    beyond_ = most > top_;
  }

  void paint(ClothPicture& picture) override {
    const auto top = static_cast<float>(top_);
    picture.options.colouring = {
        .by = Colouring::By::Strain, .ramp = Ramp::Balanced, .low = -top, .high = top, .values = {}};
  }

  void draw(const PanelScope& scope) override {
    const bool shown = scope.colouredBy == Colouring::By::Strain;
    if (shown) colourBar(scope, Ramp::Balanced, -100 * top_, 100 * top_, beyond_ ? "% and beyond" : "%");
    table(scope);
    const bool onSurface = scope.viewer.view().drawOptions().show != Show::Lines;
    paragraph(!shown      ? "The colours on the cloth are those of another panel."
              : onSurface ? "Springs that are longer than at rest are warm, shorter ones cold. The surface shows the "
                            "structural spring of each particle whose length has changed most."
                          : "Springs that are longer than at rest are warm, shorter ones cold.",
              scope.colours.dim);
  }

 private:
  static constexpr double kLeastTop = 1e-4;  ///< strains below it are rounding, not stretch

  void table(const PanelScope& scope) const {
    constexpr int kColumns = 4;
    if (!ImGui::BeginTable("families", kColumns, ImGuiTableFlags_SizingStretchProp)) return;
    for (const char* head : {"% of rest length", "mean", "longest", "shortest"}) {
      ImGui::TableNextColumn();
      ImGui::TextDisabled("%s", head);
    }
    const Scene& scene = scope.viewer.run().simulation().scene();
    for (std::size_t k = 0; k < kFamilies.size(); ++k) {
      if (!familyOf(scene, kFamilies.at(k)).present()) continue;
      const Stretch& stretch = stretches_.at(k);
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(kNames.at(k));
      for (const double strain : {stretch.mean, stretch.largest, stretch.smallest}) {
        ImGui::TableNextColumn();
        ImGui::Text("%+.2f", std::abs(strain) < kLeastTop / 2 ? 0.0 : 100 * strain);  // no -0.00
      }
    }
    ImGui::EndTable();
  }

  std::array<Stretch, kFamilies.size()> stretches_{};
  double top_ = 0;       ///< strain at both ends of the colours
  bool beyond_ = false;  ///< some springs are past the ends
};

}  // namespace

std::unique_ptr<Panel> makeStretchPanel() { return std::make_unique<StretchPanel>(); }

}  // namespace tyg

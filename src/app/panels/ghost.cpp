// See ghost.h.
#include "app/ghost.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/panels/colour_bar.h"
#include "app/panels/ghost.h"
#include "app/panels/paragraph.h"
#include "app/viewer.h"
#include "core/text.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

/// s of computing a frame: more would be felt in the frame rate, unless frames take long anyway.
constexpr double kSecondsPerFrame = 0.008, kShareOfFrame = 0.25;
constexpr float kOpacity = 0.5F;
constexpr double kTellable = 2;   // floors: from there on a distance is more than the reference's own
constexpr double kNoticed = 0.1;  // s behind, that the person is told of
constexpr float kBeside = 1.15F;  // sheet sizes from the live cloth to a ghost beside it

double secondsFor(const Viewer& viewer) {
  const double rate = viewer.pace().framesPerSecond;
  return rate > 0 ? std::max(kSecondsPerFrame, kShareOfFrame / rate) : kSecondsPerFrame;
}

class GhostPanel final : public Panel {
 public:
  void follow(Viewer& viewer) override {
    const Simulation& live = viewer.simulation();
    if (live.status() != Status::Ok) return;
    try {
      if (!ghost_) ghost_.emplace(live, second_);
      ghost_->follow(live, secondsFor(viewer), [&viewer] { return viewer.now(); });
      if (beside_) shift(viewer);
    } catch (const std::exception& refusal) {  // a method that does not take this scene
      viewer.warn(refusal.what());
      ghost_.reset();
      second_ = nullptr;
    }
  }

  void close() override { ghost_.reset(); }
  [[nodiscard]] bool busy() const override {
    return ghost_ && ghost_->behind() > 0 && ghost_->status() == Status::Ok && !ghost_->stalled();
  }

  void paint(ClothPicture& picture) override {
    if (!ghost_) return;
    picture.ghost = beside_ ? std::span<const float>(shifted_) : ghost_->positions();
    picture.ghostOpacity = beside_ ? 1 : kOpacity;
    if (!coloured_ || !ghost_->gap()) return;
    top_ = steadyTop(top_, ghost_->gap()->largest);
    picture.options.colouring = {.by = Colouring::By::Particle,
                                 .ramp = Ramp::Growing,
                                 .low = 0,
                                 .high = static_cast<float>(top_),
                                 .values = ghost_->distances()};
  }

  void draw(const PanelScope& scope) override {
    choose();
    if (second_ != nullptr) swap(scope.viewer);
    if (ImGui::RadioButton("over the cloth", !beside_)) beside_ = false;
    ImGui::SameLine();
    if (ImGui::RadioButton("beside it", beside_)) beside_ = true;
    ImGui::Checkbox("colour the cloth by its distance", &coloured_);
    if (!ghost_) return;
    distances(scope);
    state(scope);
  }

 private:
  /// A size to the left, as the camera sees it.
  void shift(const Viewer& viewer) {
    const auto size = static_cast<float>(viewer.simulation().sheet().size());
    const glm::vec3 way = -kBeside * size * viewer.camera().right();
    const std::span<const float> from = ghost_->positions();
    shifted_.resize(from.size());
    for (std::size_t i = 0; i < from.size(); ++i) shifted_[i] = from[i] + way[static_cast<int>(i % 3)];
  }

  void choose() {
    constexpr const char* kReference = "the true motion (reference)";
    const std::string chosen = second_ == nullptr ? kReference : std::string(second_->name);
    ImGui::SetNextItemWidth(-1);
    if (!ImGui::BeginCombo("##ghost", chosen.c_str())) return;
    if (ImGui::Selectable(kReference, second_ == nullptr)) use(nullptr);
    for (const Method& method : methods()) {
      if (ImGui::Selectable(std::string(method.name).c_str(), second_ == &method)) use(&method);
    }
    ImGui::EndCombo();
  }
  /// The cloth goes on with the ghost's method, and the ghost has the cloth's.
  void swap(Viewer& viewer) {
    if (!ImGui::Button("swap with the cloth's method")) return;
    const Method& cloths = viewer.method();
    Scene wanted = viewer.scene();
    wanted.integrator = second_->name;
    if (viewer.use(wanted) != SceneChange::None) use(&cloths);
  }
  void use(const Method* second) {
    second_ = second;
    ghost_.reset();
    top_ = 0;
  }

  void distances(const PanelScope& scope) {
    const std::optional<GhostGap>& gap = ghost_->gap();
    if (!gap) {
      ImGui::TextUnformatted("distance: they have not met yet");
      return;
    }
    paragraph(formatted("distance: %.2g mm RMS, %.2g mm at most", 1e3 * gap->rms, 1e3 * gap->largest),
              scope.colours.text);
    if (coloured_ && top_ > 0) colourBar(scope, Ramp::Growing, 0, 1e3 * top_, "mm");
    if (ghost_->time() == 0) return;
    if (ghost_->horizon() <= gap->time) {
      return paragraph(
          formatted("The horizon passed at %.2f s: since then the cloth has made so much of rounding and of "
                    "the smallest differences (%.2g mm) that the distance means nothing any more.",
                    ghost_->horizon(), 1e3 * gap->floor),
          scope.colours.warning);
    }
    if (gap->rms >= kTellable * gap->floor) {
      return paragraph(formatted("Distances below %.1g mm mean nothing here.", 1e3 * gap->floor), scope.colours.dim);
    }
    paragraph(formatted("As close as can be told here: within %.1g mm.", 1e3 * gap->floor), scope.colours.good);
  }

  void state(const PanelScope& scope) {
    if (ghost_->status() != Status::Ok) {
      return paragraph(formatted("The ghost's method failed at %.3f s.", ghost_->time()), scope.colours.warning);
    }
    if (ghost_->stalled()) {
      return paragraph(formatted("The ghost came to a stand at %.3f s: its steps became too many.", ghost_->time()),
                       scope.colours.warning);
    }
    if (ghost_->behind() > kNoticed) {
      paragraph(formatted("The ghost is %.2f s behind: this machine cannot compute both in time.", ghost_->behind()),
                scope.colours.warning);
    }
  }

  const Method* second_ = nullptr;  ///< null: the reference
  std::optional<Ghost> ghost_;
  bool beside_ = false, coloured_ = true;
  std::vector<float> shifted_;  ///< the ghost's positions, beside the cloth
  double top_ = 0;              ///< m, at the end of the colours
};

}  // namespace

std::unique_ptr<Panel> makeGhostPanel() { return std::make_unique<GhostPanel>(); }

}  // namespace tyg

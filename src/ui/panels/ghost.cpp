// Runs the second cloth in what is left of each frame, and hands it to the picture.
#include "ui/panels/ghost.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tyg/methods.h"
#include "ui/panels/colour_bar.h"
#include "ui/panels/paragraph.h"
#include "viewer/ghost_words.h"
#include "viewer/viewer.h"

namespace tyg {
namespace {

/// s of computing a frame: more would be felt in the frame rate, unless frames take long anyway.
constexpr double kSecondsPerFrame = 0.008, kShareOfFrame = 0.25;
constexpr float kOpacity = 0.5F;
constexpr float kBeside = 1.15F;  // sheet sizes from the live cloth to a ghost beside it

double secondsFor(const Viewer& viewer) {
  const double rate = viewer.pace().framesPerSecond;
  return rate > 0 ? std::max(kSecondsPerFrame, kShareOfFrame / rate) : kSecondsPerFrame;
}

class GhostPanel final : public Panel {
 public:
  void follow(Viewer& viewer) override {
    const Simulation& live = viewer.run().simulation();
    // Past its alarm the simulation is not what the window shows.
    const ShownTarget shown{.ticks = viewer.run().shown().tick(),
                            .time = viewer.run().shown().time(),
                            .positions = viewer.run().shown().positions()};
    const bool failed = live.status() != Status::Ok && shown.ticks <= live.ticks();
    try {
      if (!ghost_) ghost_.emplace(live, second_);
      ghost_->follow(
          live, secondsFor(viewer), [&viewer] { return viewer.run().now(); }, failed ? &shown : nullptr);
      inStep_ = std::abs(ghost_->time() - viewer.run().shown().time()) <= kNearlyInStep;
      away_ = kBeside * static_cast<float>(live.sheet().size());
      if (beside_) shift(viewer);
    } catch (const std::exception& refusal) {  // a method that does not take this scene
      viewer.notes().warn(refusal.what());
      ghost_.reset();
      second_ = nullptr;
    }
  }

  void close() override { ghost_.reset(); }
  [[nodiscard]] bool busy() const override {
    return ghost_ && ghost_->behind() > 0 && ghost_->status() == Status::Ok && !ghost_->stalled();
  }

  [[nodiscard]] float beside() const override { return ghost_ && beside_ ? away_ : 0; }

  void paint(ClothPicture& picture) override {
    if (!ghost_ || !inStep_) return;
    picture.ghost = beside_ ? std::span<const float>(shifted_) : ghost_->positions();
    picture.ghostSheet = &ghost_->sheet();
    picture.ghostOpacity = beside_ ? 1 : kOpacity;
    if (beside_) picture.ghostShift = way_;
    if (!colours()) return;
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
    if (beside_) sides(scope);
    ImGui::Checkbox("colour the cloth by its distance", &coloured_);
    if (!ghost_) return;
    say(scope, distanceWords(*ghost_));
    if (colours()) scale(scope);
    say(scope, meaningWords(*ghost_));
    say(scope, progressWords(*ghost_));
  }

 private:
  /// To the left, as the camera sees it.
  void shift(const Viewer& viewer) {
    way_ = -away_ * viewer.view().camera().right();
    const std::span<const float> from = ghost_->positions();
    shifted_.resize(from.size());
    for (std::size_t i = 0; i < from.size(); ++i) shifted_[i] = from[i] + way_[static_cast<int>(i % 3)];
  }

  void choose() {
    constexpr const char* kReference = "the true motion (reference)";
    const std::string chosen = second_ == nullptr ? kReference : std::string(second_->name);
    ImGui::SetNextItemWidth(-1);
    if (!ImGui::BeginCombo("##ghost", chosen.c_str(), ImGuiComboFlags_HeightLarge)) return;
    if (ImGui::Selectable(kReference, second_ == nullptr)) use(nullptr);
    for (const Method& method : methods()) {
      if (ImGui::Selectable(std::string(method.name).c_str(), second_ == &method)) use(&method);
    }
    ImGui::EndCombo();
  }
  /// From the start, as the ghost: a cloth that changed its method on the way would be the ghost up to there.
  void swap(Viewer& viewer) {
    if (!ImGui::Button("swap the two and restart")) return;
    const Method& cloths = viewer.scenes().method();
    const bool running = viewer.run().state() == RunState::Running;
    Scene wanted = viewer.scenes().scene();
    wanted.integrator = second_->name;
    if (second_ != &cloths && viewer.scenes().use(wanted) == SceneChange::None) return;
    use(&cloths);
    viewer.perform(InputAction::Restart);
    if (running) viewer.perform(InputAction::StartOrPause);
  }
  void use(const Method* second) {
    second_ = second;
    ghost_.reset();
    top_ = 0;
  }

  void sides(const PanelScope& scope) const {
    const std::string ghost(second_ == nullptr ? "the true motion" : second_->name);
    paragraph("left: ghost, " + ghost + "; right: the cloth, " + std::string(scope.viewer.scenes().method().name),
              scope.colours.dim);
  }
  [[nodiscard]] bool colours() const { return coloured_ && inStep_ && ghost_->gap(); }
  void scale(const PanelScope& scope) const {
    if (scope.colouredBy != Colouring::By::Particle) {
      paragraph("The colours on the cloth are those of another panel.", scope.colours.dim);
    } else if (top_ > 0) {
      colourBar(scope, Ramp::Growing, 0, 1e3 * top_, "mm");
    }
  }
  static void say(const PanelScope& scope, const Sentence& sentence) {
    if (sentence.text.empty()) return;
    const Colours& colours = scope.colours;
    const std::array inks{colours.text, colours.dim, colours.good, colours.warning};  // as Sentence::Tone has them
    paragraph(sentence.text, inks.at(static_cast<std::size_t>(sentence.tone)));
  }

  const Method* second_ = nullptr;  ///< null: the reference
  std::optional<Ghost> ghost_;
  bool beside_ = false, coloured_ = true;
  bool inStep_ = false;         ///< or nearly
  float away_ = 0;              ///< m, from the cloth to a ghost beside it
  glm::vec3 way_{0};            ///< m, the same as a vector
  std::vector<float> shifted_;  ///< the ghost's positions, beside the cloth
  double top_ = 0;              ///< m, at the end of the colours
};

}  // namespace

std::unique_ptr<Panel> makeGhostPanel() { return std::make_unique<GhostPanel>(); }

}  // namespace tyg

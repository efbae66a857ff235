// Runs the second cloth in what is left of each frame, and hands it to the picture; or shows a motion that another
// program wrote, with the verdict on it.
#include "ui/panels/ghost.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tyg/methods.h"
#include "ui/panels/colour_bar.h"
#include "ui/panels/paragraph.h"
#include "viewer/ghost_words.h"
#include "viewer/review_words.h"
#include "viewer/viewer.h"

namespace tyg {
namespace {

/// s of computing a frame: more would be felt in the frame rate, unless frames take long anyway.
constexpr double kSecondsPerFrame = 0.008, kShareOfFrame = 0.25;
constexpr float kOpacity = 0.5F;
constexpr int kFramesToSettle = 4;
constexpr float kBeside = 1.15F;  // sheet sizes from the live cloth to a ghost beside it

double secondsFor(const Viewer& viewer) {
  const double rate = viewer.pace().framesPerSecond;
  return rate > 0 ? std::max(kSecondsPerFrame, kShareOfFrame / rate) : kSecondsPerFrame;
}

/// A cloth beside the live one, as the picture needs it.
struct ShownGhost {
  const Sheet* sheet = nullptr;  ///< null: there is none
  std::span<const float> positions{}, distances{};
  double largest = 0;  ///< m, of the distances
};

class GhostPanel final : public Panel {
 public:
  void follow(Viewer& viewer) override {
    MotionReview& review = viewer.review();
    if (std::exchange(opened_, review.opened()) != review.opened()) use(nullptr), given_ = true;
    if (given_ && !review.isOpen()) use(nullptr);
    given_ ? followGiven(review) : followSecond(viewer);
    away_ = kBeside * static_cast<float>(viewer.run().simulation().sheet().size());
    if (beside_) shift(viewer);
  }

  void close() override { ghost_.reset(), shown_ = {}; }
  [[nodiscard]] bool busy() const override {
    if (given_) return settling_ > 0;
    return ghost_ && ghost_->behind() > 0 && ghost_->status() == Status::Ok && !ghost_->stalled();
  }

  [[nodiscard]] float beside() const override { return shown_.sheet != nullptr && beside_ ? away_ : 0; }

  void paint(ClothPicture& picture) override {
    if (shown_.sheet == nullptr || !inStep_) return;
    picture.ghost = beside_ ? std::span<const float>(shifted_) : shown_.positions;
    picture.ghostSheet = shown_.sheet;
    picture.ghostOpacity = beside_ ? 1 : kOpacity;
    if (beside_) picture.ghostShift = way_;
    if (!colours()) return;
    top_ = steadyTop(top_, shown_.largest);
    picture.options.colouring = {.by = Colouring::By::Particle,
                                 .ramp = Ramp::Growing,
                                 .low = 0,
                                 .high = static_cast<float>(top_),
                                 .values = shown_.distances};
  }

  void draw(const PanelScope& scope) override {
    choose(scope.viewer.review());
    if (second_ != nullptr) swap(scope.viewer);
    if (ImGui::RadioButton("over the cloth", !beside_)) beside_ = false;
    ImGui::SameLine();
    if (ImGui::RadioButton("beside it", beside_)) beside_ = true;
    if (beside_) sides(scope);
    ImGui::Checkbox("colour the cloth by its distance", &coloured_);
    if (given_ && scope.viewer.review().isOpen()) return drawGiven(scope);
    if (!ghost_) return;
    say(scope, distanceWords(*ghost_));
    if (colours()) scale(scope);
    say(scope, meaningWords(*ghost_));
    say(scope, progressWords(*ghost_));
  }

 private:
  void followSecond(Viewer& viewer) {
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
      shown_ = {.sheet = &ghost_->sheet(), .positions = ghost_->positions(), .distances = ghost_->distances()};
      if (ghost_->gap()) shown_.largest = ghost_->gap()->largest;
    } catch (const std::exception& refusal) {  // a method that does not take this scene
      viewer.notes().warn(refusal.what());
      use(nullptr);
    }
  }

  void followGiven(MotionReview& review) {
    const GivenGhost& ghost = review.ghost();
    inStep_ = ghost.place() != GivenGhost::Place::Before;
    shown_ = {.sheet = &ghost.sheet(), .positions = ghost.positions()};
    if (ghost.differs()) shown_.distances = ghost.distances(), shown_.largest = ghost.gap()->largest;
    const CheckProgress& check = review.check();
    const std::pair now{check.stage, std::lround(100 * check.fraction)};
    settling_ = std::exchange(seen_, now) != now ? kFramesToSettle : std::max(0, settling_ - 1);
  }

  /// What the check says of a motion that another program wrote, and how far the cloth is from it.
  void drawGiven(const PanelScope& scope) {
    MotionReview& review = scope.viewer.review();
    const Scene& scene = scope.viewer.scenes().scene();
    const CheckProgress& check = review.check();
    say(scope, verdictSentence(check));
    if (check.stage == CheckProgress::Stage::Running) {
      ImGui::Text("checking: %.0f %%", 100 * check.fraction);
      ImGui::SameLine();
      if (ImGui::Button("stop")) review.stopCheck();
    } else {
      const Sentence other = otherSceneWords(review, scene);
      say(scope, other);
      const bool again = check.stage == CheckProgress::Stage::Stopped || !other.text.empty();
      if (again && ImGui::Button("check again")) review.checkAgain(scene);
    }
    say(scope, gapWords(review.ghost()));
    if (colours()) scale(scope);
    say(scope, placeWords(review));
  }

  /// To the left, as the camera sees it.
  void shift(const Viewer& viewer) {
    way_ = -away_ * viewer.view().camera().right();
    shifted_.resize(shown_.positions.size());
    for (std::size_t i = 0; i < shifted_.size(); ++i) shifted_[i] = shown_.positions[i] + way_[static_cast<int>(i % 3)];
  }

  void choose(const MotionReview& review) {
    constexpr const char* kReference = "the true motion (reference)";
    const std::string chosen = given_ ? review.name() : second_ == nullptr ? kReference : std::string(second_->name);
    ImGui::SetNextItemWidth(-1);
    if (!ImGui::BeginCombo("##ghost", chosen.c_str(), ImGuiComboFlags_HeightLarge)) return;
    if (review.isOpen() && ImGui::Selectable(review.name().c_str(), given_)) use(nullptr), given_ = true;
    if (ImGui::Selectable(kReference, second_ == nullptr && !given_)) use(nullptr);
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
    given_ = false;
    ghost_.reset();
    shown_ = {};
    top_ = 0;
  }

  void sides(const PanelScope& scope) const {
    const std::string ghost = given_               ? scope.viewer.review().name()
                              : second_ == nullptr ? "the true motion"
                                                   : std::string(second_->name);
    paragraph("left: ghost, " + ghost + "; right: the cloth, " + std::string(scope.viewer.scenes().method().name),
              scope.colours.dim);
  }
  [[nodiscard]] bool colours() const { return coloured_ && inStep_ && !shown_.distances.empty(); }
  void scale(const PanelScope& scope) const {
    if (scope.colouredBy != Colouring::By::Particle) {
      paragraph("The colours on the cloth are those of another panel.", scope.colours.dim);
    } else if (top_ > 0) {
      const bool isLong = top_ >= 1;
      colourBar(scope, Ramp::Growing, 0, isLong ? top_ : 1e3 * top_, isLong ? "m" : "mm");
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
  bool given_ = false;  ///< it is a motion that another program wrote, and neither of the two above
  int opened_ = 0;      ///< of such motions, the last one seen
  std::pair<CheckProgress::Stage, long> seen_{};
  int settling_ = 0;  ///< frames until the panel is as high as what it says
  ShownGhost shown_;
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

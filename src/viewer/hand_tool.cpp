// A press is not yet a push: it is one as soon as the button comes up or has been down for a moment without moving, and
// a grab as soon as the cursor has moved by a few pixels. So no grab begins with a push. A press on a body that no
// cloth hides is for the body.
#include "viewer/hand_tool.h"

#include <algorithm>
#include <array>
#include <utility>

#include "view/picking.h"
#include "viewer/body_grab.h"
#include "viewer/grab.h"
#include "viewer/push.h"

namespace tyg {
namespace {

constexpr float kStillPixels = 4;      // the cursor of a hand that means to hold still moves no farther
constexpr double kStillSeconds = 0.2;  // of the clock, after which a still button pushes
constexpr float kFarPixels = 60;       // from the cloth: a click this far away was not meant for it

class HandTool final : public Tool {
 public:
  bool press(const ToolScope& scope, glm::vec2 cursor) override {
    const std::optional<int> hit = particleNear(scope, cursor, kPickRadius);
    pressedAt_ = cursor;
    body_ = BodyGrab::bodyAt(scope, cursor, hit);
    if (body_) return isDown_ = true;
    if (!hit) return false;
    particle_ = *hit;
    away_ = sightLine(scope.view.camera(), cursor, windowOf(scope)).direction;
    aside_ = placeInWindow(scope.view.camera(), placeOf(scope, particle_), windowOf(scope)) - cursor;
    pressedTime_ = scope.run.now();
    return isDown_ = waits_ = true;
  }

  /// As the report's program does, but only where nothing else can be meant.
  void clickBeside(const ToolScope& scope, glm::vec2 cursor) override {
    if (particleNear(scope, cursor, kFarPixels)) return scope.notes.say("That click missed the cloth.");
    const Sheet& sheet = scope.run.simulation().sheet();
    if (!sheet.missing.none()) return scope.notes.say("That click missed the cloth.");
    particle_ = particleAt(sheet, Place{.name = "middle"});
    if (!isInView(scope, particle_)) return scope.notes.say("F fits the cloth in view.");
    away_ = {0, 0, 1};
    push(scope);
    push_.release();
    scope.notes.say("A click beside the cloth pushes its middle.");
  }

  void move(const ToolScope& scope, glm::vec2 cursor) override {
    if (grab_.holds()) return grab_.move(cursor);
    if (bodyGrab_.holds()) return bodyGrab_.move(cursor);
    if (!isDown_ || glm::distance(cursor, pressedAt_) <= kStillPixels) return;
    isDown_ = waits_ = false;
    if (body_ && !canMove(scope)) return sayWhatADragDoes(scope);
    start(scope);
    if (body_) {
      bodyGrab_.begin(scope, *body_, pressedAt_);
      bodyGrab_.move(cursor);
      ++scope.record.uses;
      return;
    }
    push_.release();
    grab_.begin(scope, particle_, cursor, aside_);
    scope.record.picked = particle_;
    ++scope.record.uses;
  }

  void release(const ToolScope& scope) override {
    if (waits_) push(scope);
    if (isDown_ && body_) sayWhatADragDoes(scope);
    letGo(scope);
  }

  void letGo(const ToolScope& scope) override {
    isDown_ = waits_ = false;
    push_.release();
    grab_.release(scope);
    bodyGrab_.release();
  }

  bool scroll(const ToolScope& /*scope*/, float notches) override {
    if (bodyGrab_.holds()) return bodyGrab_.pushAway(notches), true;
    if (!grab_.holds()) return false;
    grab_.pushAway(notches);
    return true;
  }

  void frame(const ToolScope& scope) override {
    if (waits_ && scope.run.now() - pressedTime_ >= kStillSeconds) push(scope);
    grab_.frame(scope);
    bodyGrab_.frame(scope);
  }

  std::int64_t follow(Simulation& simulation, std::int64_t due) override {
    return std::min({push_.follow(simulation), grab_.follow(simulation, due), bodyGrab_.follow(simulation, due)});
  }

  [[nodiscard]] bool actsAt(std::int64_t tick) const override {
    return push_.actsAt(tick) || grab_.holds() || bodyGrab_.holds();
  }

  void restart() override {
    isDown_ = waits_ = false;
    push_.restart();
    grab_.forget();
    bodyGrab_.release();
  }

  [[nodiscard]] ToolDrawing drawing(const RunControl& run) const override {
    return {.arrow = push_.arrow(run), .cut = {}};
  }

 private:
  void push(const ToolScope& scope) {
    waits_ = false;
    if (scope.run.state() == RunState::Frozen || scope.run.seeking()) return;
    const Sheet& sheet = scope.run.simulation().sheet();
    const glm::dvec3 force = scope.record.strength * usualPush(sheet) * glm::dvec3(away_);
    push_.begin(scope.run, particle_, {force.x, force.y, force.z});
    scope.record.picked = particle_;
    ++scope.record.pushes, ++scope.record.uses;
    if (std::ranges::binary_search(sheet.pins, particle_)) {
      scope.notes.say("That particle is pinned: no push moves it. A drag does.");
    }
    start(scope);
  }

  [[nodiscard]] bool canMove(const ToolScope& scope) const {
    return BodyGrab::canMove(scope.run.simulation().scene(), body_->body);
  }
  void sayWhatADragDoes(const ToolScope& scope) const {
    scope.notes.say(canMove(scope) ? "A drag moves this body."
                                   : "Of the bodies of a scene only the first six can be moved.");
  }

  /// What is done to a cloth that has never moved is to be seen.
  static void start(const ToolScope& scope) {
    if (scope.run.state() == RunState::Waiting) scope.run.goOn();
  }

  static std::optional<int> particleNear(const ToolScope& scope, glm::vec2 cursor, float pixels) {
    const RunControl& run = scope.run;
    return pickParticle(scope.view.camera(), cursor, windowOf(scope), run.simulation().sheet(), run.shown().positions(),
                        pixels);
  }
  static glm::vec3 placeOf(const ToolScope& scope, int particle) {
    const auto xyz = scope.run.shown().positions().subspan(3 * static_cast<std::size_t>(particle), 3);
    return {xyz[0], xyz[1], xyz[2]};
  }
  static bool isInView(const ToolScope& scope, int particle) {
    const Camera& camera = scope.view.camera();
    const glm::vec3 there = placeOf(scope, particle);
    const glm::vec2 place = placeInWindow(camera, there, windowOf(scope)), window = windowOf(scope);
    const bool ahead = glm::dot(there - camera.eye(), camera.forward()) > 0;
    return ahead && place.x >= 0 && place.y >= 0 && place.x < window.x && place.y < window.y;
  }

  HeldPush push_;
  Grab grab_;
  BodyGrab bodyGrab_;
  std::optional<PickedBody> body_;  ///< under the cursor when the button went down
  bool isDown_ = false;             ///< and may become a grab
  bool waits_ = false;              ///< and may become a push
  int particle_ = 0;
  glm::vec3 away_{0, 0, 1};  ///< along which a push goes, a unit vector
  glm::vec2 pressedAt_{0};   ///< pixels
  glm::vec2 aside_{0};       ///< pixels, from there to the particle
  double pressedTime_ = 0;   ///< s, of the clock
};

/// A pointing hand.
constexpr std::array kIcon{glm::vec2(.38F, .62F), glm::vec2(.38F, .12F), glm::vec2(.44F, .05F), glm::vec2(.50F, .12F),
                           glm::vec2(.50F, .46F), glm::vec2(.60F, .42F), glm::vec2(.64F, .50F), glm::vec2(.74F, .46F),
                           glm::vec2(.78F, .54F), glm::vec2(.86F, .52F), glm::vec2(.90F, .60F), glm::vec2(.88F, .78F),
                           glm::vec2(.80F, .96F), glm::vec2(.46F, .96F), glm::vec2(.16F, .64F), glm::vec2(.22F, .56F),
                           glm::vec2(.38F, .70F), glm::vec2(.38F, .60F)};

}  // namespace

std::unique_ptr<Tool> makeHandTool() { return std::make_unique<HandTool>(); }
std::span<const glm::vec2> handIcon() { return kIcon; }

}  // namespace tyg

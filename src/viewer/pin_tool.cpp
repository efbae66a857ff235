// Everything happens when the button goes down; holding it does nothing more.
#include "viewer/pin_tool.h"

#include <algorithm>
#include <array>
#include <limits>

#include "view/picking.h"

namespace tyg {
namespace {

class PinTool final : public Tool {
 public:
  bool press(const ToolScope& scope, glm::vec2 cursor) override {
    const glm::vec2 window(scope.view.pixels().width, scope.view.pixels().height);
    const Sheet& sheet = scope.run.simulation().sheet();
    const auto hit = pickParticle(scope.view.camera(), cursor, window, sheet, scope.run.shown().positions());
    if (!hit) return false;
    Simulation& simulation = scope.run.intervene();
    simulation.pin(*hit, !std::ranges::binary_search(simulation.sheet().pins, *hit));
    scope.record.picked = *hit;
    ++scope.record.uses;
    return true;
  }
  void clickBeside(const ToolScope& scope, glm::vec2 /*cursor*/) override {
    scope.notes.say("There is no cloth to pin here.");
  }
  void release(const ToolScope& /*scope*/) override {}
  std::int64_t follow(Simulation& /*simulation*/, std::int64_t /*due*/) override {
    return std::numeric_limits<std::int64_t>::max();
  }
  [[nodiscard]] bool actsAt(std::int64_t /*tick*/) const override { return false; }
  void restart() override {}
  [[nodiscard]] ToolDrawing drawing(const RunControl& /*run*/) const override { return {}; }
};

/// A pin with a round head, stuck in aslant.
constexpr std::array kIcon{glm::vec2(.12F, .92F), glm::vec2(.46F, .54F), kPenUp,
                           glm::vec2(.88F, .32F), glm::vec2(.84F, .47F), glm::vec2(.74F, .57F),
                           glm::vec2(.60F, .60F), glm::vec2(.46F, .54F), glm::vec2(.40F, .40F),
                           glm::vec2(.42F, .26F), glm::vec2(.53F, .15F), glm::vec2(.68F, .12F),
                           glm::vec2(.82F, .19F), glm::vec2(.88F, .32F)};

}  // namespace

std::unique_ptr<Tool> makePinTool() { return std::make_unique<PinTool>(); }
std::span<const glm::vec2> pinIcon() { return kIcon; }

}  // namespace tyg

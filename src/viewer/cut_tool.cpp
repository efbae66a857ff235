// The line lives on the screen until it is released; what is logged then are lines on the grid.
#include "viewer/cut_tool.h"

#include <array>
#include <limits>
#include <utility>

#include "view/cut_path.h"

namespace tyg {
namespace {

constexpr float kShortest = 4;  // pixels: a shorter drag is a click

class CutTool final : public Tool {
 public:
  bool press(const ToolScope& /*scope*/, glm::vec2 cursor) override {
    line_ = {cursor, cursor};
    return draws_ = true;
  }
  void move(const ToolScope& /*scope*/, glm::vec2 cursor) override { line_.to = cursor; }
  void release(const ToolScope& scope) override {
    const bool draws = std::exchange(draws_, false);
    if (!draws || scope.run.state() == RunState::Frozen || scope.run.seeking() || !scope.view.visible()) return;
    if (glm::distance(line_.from, line_.to) < kShortest) {
      return scope.notes.say("Drag a line across the cloth: it is cut along it when you let go.");
    }
    cut(scope);
  }
  void letGo(const ToolScope& /*scope*/) override { draws_ = false; }
  std::int64_t follow(Simulation& /*simulation*/, std::int64_t /*due*/) override {
    return std::numeric_limits<std::int64_t>::max();
  }
  [[nodiscard]] bool actsAt(std::int64_t /*tick*/) const override { return false; }
  void restart() override { draws_ = false; }
  [[nodiscard]] ToolDrawing drawing(const RunControl& run) const override {
    if (!draws_ || run.state() == RunState::Frozen) return {};
    return {.arrow = {}, .cut = line_};
  }

 private:
  void cut(const ToolScope& scope) const {
    const glm::vec2 window(scope.view.pixels().width, scope.view.pixels().height);
    const Sheet& sheet = scope.run.simulation().sheet();
    bool isCut = false;
    for (const CutLine& line :
         cutsAlong(scope.view.camera(), line_.from, line_.to, window, sheet, scope.run.shown().positions())) {
      if (sheet.missing.withCut(sheet.columns, sheet.rows, line) == sheet.missing) continue;  // it would take nothing
      scope.run.intervene().cut(line);
      isCut = true;
    }
    if (!isCut) return scope.notes.say("That line crosses no spring.");
    ++scope.record.uses;
  }

  ScreenLine line_;
  bool draws_ = false;
};

/// Open scissors: two blades that cross, and two rings.
constexpr std::array kIcon{glm::vec2(.30F, .05F), glm::vec2(.64F, .68F), kPenUp,
                           glm::vec2(.70F, .05F), glm::vec2(.36F, .68F), kPenUp,
                           glm::vec2(.36F, .68F), glm::vec2(.42F, .80F), glm::vec2(.38F, .92F),
                           glm::vec2(.27F, .96F), glm::vec2(.16F, .90F), glm::vec2(.14F, .78F),
                           glm::vec2(.22F, .68F), glm::vec2(.36F, .68F), kPenUp,
                           glm::vec2(.64F, .68F), glm::vec2(.58F, .80F), glm::vec2(.62F, .92F),
                           glm::vec2(.73F, .96F), glm::vec2(.84F, .90F), glm::vec2(.86F, .78F),
                           glm::vec2(.78F, .68F), glm::vec2(.64F, .68F)};

}  // namespace

std::unique_ptr<Tool> makeCutTool() { return std::make_unique<CutTool>(); }
std::span<const glm::vec2> cutIcon() { return kIcon; }

}  // namespace tyg

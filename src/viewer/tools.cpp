// Every tool is made once, at the start: what one of them left acting goes on when another one is chosen.
#include "viewer/tools.h"

#include <algorithm>
#include <limits>
#include <string>

#include "tyg/input_error.h"
#include "util/text.h"

namespace tyg {

Tools::Tools(RunControl& run, const ViewControl& view, Notes& notes) : run_(run), view_(view), notes_(notes) {
  for (const ToolKind& kind : toolTable()) tools_.push_back(kind.make());
}

void Tools::choose(std::string_view name) {
  const std::span<const ToolKind> table = toolTable();
  const auto kind = std::ranges::find(table, name, &ToolKind::name);
  if (kind == table.end()) {
    throw InputError("tool: found \"" + std::string(name) + "\", allowed: " + joined(table, &ToolKind::name));
  }
  choose(static_cast<std::size_t>(kind - table.begin()));
}

void Tools::choose(std::size_t slot) {
  if (slot >= tools_.size()) return;
  letGo();
  chosen_ = slot;
}

bool Tools::canAct() const { return run_.state() != RunState::Frozen && !run_.seeking() && view_.visible(); }

bool Tools::press(glm::vec2 cursor) { return pressed_ = canAct() && chosen().press(scope(), cursor); }

void Tools::clickBeside(glm::vec2 cursor) {
  if (canAct()) chosen().clickBeside(scope(), cursor);
}

void Tools::release() {
  pressed_ = false;
  chosen().release(scope());
}

void Tools::letGo() {
  pressed_ = false;
  chosen().letGo(scope());
}

void Tools::frame() {
  for (const auto& tool : tools_) tool->frame(scope());
}

std::int64_t Tools::follow(Simulation& simulation, std::int64_t due) {
  std::int64_t ticks = std::numeric_limits<std::int64_t>::max();
  for (const auto& tool : tools_) ticks = std::min(ticks, tool->follow(simulation, due));
  return ticks;
}

bool Tools::actsAt(std::int64_t tick) const {
  return std::ranges::any_of(tools_, [tick](const auto& tool) { return tool->actsAt(tick); });
}

void Tools::restart() {
  for (const auto& tool : tools_) tool->restart();
}

ToolDrawing Tools::drawing() const {
  for (const auto& tool : tools_) {
    if (const ToolDrawing drawing = tool->drawing(run_); !drawing.empty()) return drawing;
  }
  return {};
}

void Tools::setStrength(double factor) {
  constexpr double kMost = 100;
  record_.strength = std::clamp(factor, 1 / kMost, kMost);
}

}  // namespace tyg

// Every tool is made once, at the start: what one of them left acting goes on when another one is chosen.
#include "viewer/tools.h"

#include <algorithm>

namespace tyg {

Tools::Tools(RunControl& run, const ViewControl& view, Notes& notes) : run_(run), view_(view), notes_(notes) {
  for (const ToolKind& kind : toolTable()) tools_.push_back(kind.make());
}

void Tools::press(glm::vec2 cursor) {
  if (run_.state() == RunState::Frozen || run_.seeking() || !view_.visible()) return;
  chosen().press(scope(), cursor);
}

bool Tools::actsAt(std::int64_t tick) const {
  return std::ranges::any_of(tools_, [tick](const auto& tool) { return tool->actsAt(tick); });
}

void Tools::restart() {
  for (const auto& tool : tools_) tool->restart();
}

void Tools::setStrength(double factor) {
  constexpr double kMost = 100;
  record_.strength = std::clamp(factor, 1 / kMost, kMost);
}

}  // namespace tyg

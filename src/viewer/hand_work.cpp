// The log is the only source, so that hand work goes back with the run to a past time.
#include "viewer/hand_work.h"

#include <algorithm>

namespace tyg {
namespace {

/// A particle that was pinned and then freed is as it was.
void note(const PinEvent& pin, std::vector<PinEvent>& pins) {
  const auto place = std::ranges::lower_bound(pins, pin.particle, {}, &PinEvent::particle);
  if (place == pins.end() || place->particle != pin.particle) {
    pins.insert(place, pin);
  } else if (place->pinned != pin.pinned) {
    pins.erase(place);
  }
}

/// Of those that the other list has not.
std::vector<PinEvent> without(std::vector<PinEvent> pins, const std::vector<PinEvent>& other) {
  std::erase_if(pins, [&](const PinEvent& pin) { return std::ranges::find(other, pin) != other.end(); });
  return pins;
}

}  // namespace

HandWork handWork(const EventLog& log) {
  HandWork work;
  for (const Event& event : log.events) {
    if (const auto* cut = std::get_if<CutEvent>(&event.action)) work.cuts.push_back(cut->line);
    if (const auto* pin = std::get_if<PinEvent>(&event.action)) note(*pin, work.pins);
    if (const auto* mend = std::get_if<MendEvent>(&event.action)) {
      work.cuts.resize(work.cuts.size() - std::min(work.cuts.size(), static_cast<std::size_t>(mend->cuts)));
    }
  }
  return work;
}

void applyHandWork(const HandWork& from, const HandWork& to, Simulation& simulation) {
  const auto differ = std::ranges::mismatch(from.cuts, to.cuts);
  if (const auto unwanted = from.cuts.end() - differ.in1; unwanted > 0) simulation.mend(static_cast<int>(unwanted));
  for (auto cut = differ.in2; cut != to.cuts.end(); ++cut) simulation.cut(*cut);
  for (const PinEvent& pin : without(from.pins, to.pins)) simulation.pin(pin.particle, !pin.pinned);
  for (const PinEvent& pin : without(to.pins, from.pins)) simulation.pin(pin.particle, pin.pinned);
}

}  // namespace tyg

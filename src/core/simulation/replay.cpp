// The methods that the events name are looked up before the run begins, so that a wrong name does not stop it halfway.
#include "core/simulation/replay.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "util/text.h"

namespace tyg {

Scene loggedScene(const EventLog& log, std::span<const std::string_view> methods) {
  if (log.sceneText.empty()) return loadScene(log.scene, methods);
  Scene scene = parseScene(log.sceneText, "the scene in the log", methods);
  scene.name = log.scene;
  return scene;
}

const Method& methodNamed(std::string_view name, std::span<const Method> methods) {
  const auto found = std::ranges::find(methods, name, &Method::name);
  if (found == methods.end()) {
    throw InputError(
        fmt::format("replay: found the unknown method \"{}\", allowed: {}", name, joined(methods, &Method::name)));
  }
  return *found;
}

Replay::Replay(std::vector<Event> events, std::span<const Method> methods) : methods_(methods) {
  for (const Event& event : events) {
    if (const auto* change = std::get_if<MethodEvent>(&event.action)) (void)methodNamed(change->method, methods);
  }
  events_ = std::make_shared<const std::vector<Event>>(std::move(events));
}

const Event* Replay::takeDue(std::int64_t tick) {
  const Event* event = next();
  if (event == nullptr || event->tick > tick) return nullptr;
  ++next_;
  return event;
}

std::int64_t Replay::ticksToNext(std::int64_t tick, std::int64_t most) const {
  return next() == nullptr ? most : std::min(most, next()->tick - tick);
}

}  // namespace tyg

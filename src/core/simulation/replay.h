// The events of a log that are still to happen in a run. A regular type, so that a checkpoint is a copy; the events
// themselves are shared by all copies. Must not know: what an event does to a simulation.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "tyg/event_log.h"
#include "tyg/method.h"
#include "tyg/scene.h"

namespace tyg {

/// The scene that a log carries, or else the one that it names. Throws InputError where that cannot be read.
Scene loggedScene(const EventLog& log, std::span<const std::string_view> methods);

/// Throws InputError where none of the methods has this name.
const Method& methodNamed(std::string_view name, std::span<const Method> methods);

class Replay {
 public:
  Replay() = default;
  /// Events in ascending order of their ticks. Throws InputError where one names a method that is not among these.
  Replay(std::vector<Event> events, std::span<const Method> methods);

  /// The next event, where it takes effect at this tick or before: the one after it is next then. Else null.
  const Event* takeDue(std::int64_t tick);
  /// Ticks from this one to the next event, or `most` where that is less.
  [[nodiscard]] std::int64_t ticksToNext(std::int64_t tick, std::int64_t most) const;
  [[nodiscard]] std::span<const Method> methods() const { return methods_; }

 private:
  [[nodiscard]] const Event* next() const { return events_ && next_ < events_->size() ? &(*events_)[next_] : nullptr; }

  std::shared_ptr<const std::vector<Event>> events_;
  std::size_t next_ = 0;
  std::span<const Method> methods_;
};

}  // namespace tyg

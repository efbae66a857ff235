// The kinds of events: the name of each in a log, and its columns.
// Must not know: how a log lays out its lines, what an event does to a simulation.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/forces/parameter.h"
#include "tyg/event_log.h"

namespace tyg {

/// Goes through the columns of an event in their order, one call a column. What it does with them is up to the class
/// that implements it: names, writes, reads or checks them.
class EventColumns {
 public:
  virtual ~EventColumns() = default;
  /// The index of a particle of the sheet.
  virtual void particle(std::string_view name, int& index) = 0;
  /// A whole number from 1.
  virtual void count(std::string_view name, int& number) = 0;
  /// 1 or 0.
  virtual void flag(std::string_view name, bool& value) = 0;
  virtual void number(std::string_view name, double& number, Allowed allowed) = 0;
  /// A word that is not empty and, where `allowed` names some, one of these.
  virtual void word(std::string_view name, std::string& word, std::span<const std::string_view> allowed) = 0;
};

/// An entry of the table of kinds, which has the order of the alternatives of EventAction.
struct EventKind {
  std::string_view name;
  std::string_view note;  ///< what a log's head says of its columns besides their names; may be empty
  EventAction (*make)();  ///< an event of this kind with the defaults of its struct
  void (*visit)(EventAction& action, EventColumns& columns);
};

std::span<const EventKind> eventKinds();
const EventKind& kindOf(const EventAction& action);
/// `tick,push,particle,...`: the columns of the lines of this kind, or of this event.
std::string columnNames(const EventAction& action);
/// `,210,0,0,2.5,50`: the values in the columns after tick and kind, as a log writes them.
std::string columnValues(const EventAction& action);

/// The log of a run of this scene with this method, before anything has happened.
EventLog beginLog(const Scene& scene, std::string_view integrator);
/// Throws InputError where `log` cannot be replayed by a simulation whose own log, at its start, is `own`.
void refuseUnfitLog(const EventLog& log, const EventLog& own);

}  // namespace tyg

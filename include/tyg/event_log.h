// What happened to a running cloth, tick by tick, so that it can happen again to the same bits; and the text that keeps
// it. Sixth of the headers to read, after methods.h; simulation.h, the last one, makes such logs and replays them.
// Must not know: windows, files, the simulation.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "tyg/scene.h"

namespace tyg {

/// A constant force acts on one particle for a whole number of ticks.
struct PushEvent {
  int particle = 0;  ///< index, row * columns + column
  Vec3 force{};      ///< N
  int ticks = 1;     ///< >= 1
  bool operator==(const PushEvent&) const = default;
};

/// The simulation goes on with another method.
struct MethodEvent {
  std::string method;  ///< its name
  bool operator==(const MethodEvent&) const = default;
};

/// The simulation goes on with another step, which is also the length of a tick.
struct StepEvent {
  double dt = 0;  ///< s, > 0
  bool operator==(const StepEvent&) const = default;
};

/// One parameter of the springs, the world or the run has another value from now on.
struct WorldEvent {
  std::string parameter;  ///< `springs.shear.ks`, `world.gravity`, `run.tolerance` and so on: table and key of a scene
  Vec3 value{};           ///< in the unit that a scene file has for it; a single number is x, with y and z 0
  bool operator==(const WorldEvent&) const = default;
};

/// A particle is pinned where it is, or is a pin no longer.
struct PinEvent {
  int particle = 0;
  bool pinned = true;
  bool operator==(const PinEvent&) const = default;
};

/// A hand holds a particle and moves it with this velocity until the next such event or a ReleaseEvent.
struct GrabEvent {
  int particle = 0;
  Vec3 velocity{};  ///< m/s
  bool operator==(const GrabEvent&) const = default;
};

/// The hand lets go: the particle flies on with the velocity that it has, or is the pin that it was.
struct ReleaseEvent {
  int particle = 0;
  bool operator==(const ReleaseEvent&) const = default;
};

/// The cloth is cut.
struct CutEvent {
  CutLine line;
  bool operator==(const CutEvent&) const = default;
};

/// The last cuts by hand are taken back.
struct MendEvent {
  int cuts = 1;  ///< >= 1
  bool operator==(const MendEvent&) const = default;
};

/// What can happen. A further kind is one more struct here, and one entry in core/simulation/event_kinds.cpp.
using EventAction =
    std::variant<PushEvent, MethodEvent, StepEvent, WorldEvent, PinEvent, GrabEvent, ReleaseEvent, CutEvent, MendEvent>;

struct Event {
  std::int64_t tick = 0;  ///< the event takes effect at the beginning of this tick
  EventAction action;
  bool operator==(const Event&) const = default;
};

/// Everything that happened in a run, and what it happened to.
struct EventLog {
  std::string scene;  ///< built-in name or path
  int columns = 0, rows = 0;
  std::string integrator;  ///< at the start
  double dt = 0;           ///< s, at the start
  Precision precision = Precision::Double;
  std::int64_t ticks = 0;       ///< length of the run
  std::string hash{};           ///< of the state at the end, hexadecimal; empty where nobody asked
  std::vector<Event> events{};  ///< in ascending order of their ticks
  std::string sceneText{};  ///< TOML of the scene as the run began it, whatever its file says by now; empty: not known
  bool operator==(const EventLog&) const = default;
};

/// The log as text, version 2. Numbers have the fewest digits that read back as the same bits. For example:
///
///     # version = 2
///     # scene = curtain
///     (further `# key = value` lines: columns, rows, integrator, dt, precision, ticks, hash)
///     ## title = "Curtain"
///     (the scene's own text, each line after `## `)
///     # push: tick,push,particle,fx_N,fy_N,fz_N,ticks
///     (one such line for each kind of event in it: it names the columns of the lines of that kind)
///     # world: tick,world,parameter,value,value_y,value_z
///     (a parameter that is a single number has `value` alone; the unit is that of the parameter)
///     tick,event,...
///     12,push,210,0,0,2.5,50
///     40,world,world.gravity,0,-1.62,0
///
/// Spreadsheets read it as CSV. The lines of one kind of event are a table in which every column has one meaning.
std::string formatEventLog(const EventLog& log);

/// Reads a log of version 2, or of version 1, whose events all had the columns
/// `tick,event,particle,fx,fy,fz,ticks,method,dt`. Throws InputError with file, line, what was found and what is
/// allowed.
EventLog parseEventLog(std::string_view text, const std::string& fileName);

}  // namespace tyg

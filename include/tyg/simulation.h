// A simulation: a scene set in motion by a method. Last of the headers to read: make one from a Scene and a Method,
// call tick() or advanceTo(), ask for positions and energies. All that viewers, studies and tests talk to.
// Must not know: windows, files, clocks.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "tyg/energies.h"
#include "tyg/event_log.h"
#include "tyg/method.h"
#include "tyg/scene.h"
#include "tyg/sheet.h"

namespace tyg {

/// Ok: nothing has gone wrong. Unstable: the energy alarm has gone off. NotFinite: a number is infinite or NaN, or a
/// method that chooses its own steps finds none that keeps its tolerance and is long enough for the run ever to end;
/// such a run advances no further, even with Settings::keepGoing.
enum class Status { Ok, Unstable, NotFinite };
/// `ok`, `unstable`, `not-finite`.
std::string_view nameOf(Status status);

/// The energies of a run, in J. Kinetic + all that is stored + dissipated - all work keeps its start value.
struct Ledger {
  double kinetic = 0;
  Energies stored{};       ///< by name: `elastic`, `gravitational`, which is zero at the start, and others where
                           ///< a scene has them, such as `contact`
  Energies work{};         ///< by what does it: `pushes`, force times the distance moved, exact
  double dissipated = 0;   ///< by damping and drag; only with Settings::ledger
  double scale = 0;        ///< what counts as a large energy in this run; S of the alarm
  double storedRise = 0;   ///< largest rise so far of K + E + G - W above its lowest value before, as a fraction of
                           ///< the scale and of what the alarm allows the first steps
  double balanceRise = 0;  ///< the same with the alarm's estimate of what damping and drag have taken added
  double drift = 0;        ///< change of the sum since the start as a fraction of scale; only with Settings::ledger
  double maxStretch = 0;   ///< largest elongation of a spring seen at the energy checks (every 64 steps, and wherever
                           ///< a run stops), as a fraction of its rest length

  /// Kinetic and all that is stored, J.
  [[nodiscard]] double mechanical() const { return kinetic + stored.sum(); }
};

/// What a run looks like at a moment.
struct Glance {
  Ledger ledger;
  Status status = Status::Ok;
};

class Device;
class DevicePositions;

/// What a caller may ask of a simulation besides its scene.
struct Settings {
  int threads = 0;         ///< 0: one for sheets too small to gain from more, else one for each core
  bool ledger = false;     ///< follow the dissipated energy: a step then takes 1.6 times (double) to 2.6 times (float)
                           ///< as long
  bool keepGoing = false;  ///< run on after the energy alarm
  /// What moves the cloth in place of the processor, in float, such as the graphics card that the program itself can
  /// take; null: the processor does.
  std::shared_ptr<Device> device{};
};

/// A checkpoint: a complete copy of a moving simulation. Restoring it and going on gives the same bits as never having
/// stopped.
class Snapshot {
 public:
  [[nodiscard]] double time() const { return time_; }          ///< s
  [[nodiscard]] std::int64_t ticks() const { return ticks_; }  ///< since the start
  [[nodiscard]] std::size_t bytes() const { return bytes_; }   ///< of memory that it takes

 private:
  friend class Simulation;
  double time_ = 0;
  std::int64_t ticks_ = 0;
  std::size_t bytes_ = 0;
  std::shared_ptr<const void> checkpoint_;
};

class Simulation {
 public:
  /// Sets the scene up in its own precision. Throws InputError where pins or pushes lie outside the sheet, where a
  /// number is too large or too small to compute with (a size outside 1e-30 to 1e30), or where the method does not take
  /// the scene.
  Simulation(const Scene& scene, const Method& method, const Settings& settings = {});
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// Steps until `time` (s), which is met exactly, as are the begins and ends of pushes on the way. Returns early when
  /// the alarm goes off (unless keepGoing) or the observer says stop.
  void advanceTo(double time);
  /// Advances by exactly `count` ticks of dt; a tick is cut where a scene's push begins or ends inside it. Stops early
  /// as advanceTo does, but between ticks: one that the observer stops has not begun. Many at once are the same bits as
  /// one by one, and faster; none where `count` is below 1.
  void tick(std::int64_t count = 1);
  /// Called about every 64 steps, oftener for large sheets; return false to stop. For progress and interruption.
  void observe(std::function<bool()> observer);

  /// Pushes a particle from the next tick on for a whole number of ticks (>= 1). Force in N. This and the three
  /// functions after it add to the log. Throws InputError for a particle outside the sheet or too few ticks.
  void push(int particle, const Vec3& force, int ticks);
  /// Goes on with another method from the next tick on. Throws InputError where it does not take the scene.
  void useMethod(const Method& method);
  /// Goes on with another step (s) from the next tick on. Throws InputError where it is not positive.
  void useStep(double dt);
  /// Goes on with the springs, the gravity, the drag and the tolerance of this scene from the next tick on; the rest of
  /// it is not used. What that adds to the energies counts as work. Throws InputError where the method does not take
  /// them.
  void useLiveParameters(const Scene& scene);
  /// Pins a particle where it is, or frees it, from the next tick on. This and the four functions after it add to the
  /// log, and throw InputError for a particle outside the sheet.
  void pin(int particle, bool pinned);
  /// From the next tick on a hand holds a particle and moves it with this velocity (m/s), whatever pulls at it, until
  /// it is given another one or released: it is a pin that moves, and what it does counts as the work of pins.
  void grab(int particle, const Vec3& velocity);
  /// Lets go: the particle keeps its velocity, or is again the pin that it was.
  void release(int particle);
  /// Cuts the cloth along a line in grid coordinates, from the next tick on. What the springs that it takes hold counts
  /// as dissipated. Throws InputError for a line without length.
  void cut(const CutLine& line);
  /// Takes back the last cuts that cut() made, as many of them as there are.
  void mend(int cuts = 1);
  /// From the next tick on, does what happened to another simulation of the same sheet, whenever that was. `methods` is
  /// where the name of a method is looked up. Throws InputError where it does not fit this simulation.
  void apply(const Event& event, std::span<const Method> methods);
  /// Lets everything that a log says happen at its tick, from now (tick 0) on. Throws InputError where the log does not
  /// fit this simulation.
  void replay(const EventLog& log, std::span<const Method> methods);
  /// Whether to follow the dissipated energy, from now on (see Settings::ledger): the drift then counts from now. The
  /// motion stays the same to the last bit.
  void followLedger(bool on);
  /// Whether to run on after the alarm, from now on.
  void keepGoing(bool yes);

  [[nodiscard]] double time() const;         ///< s
  [[nodiscard]] std::int64_t ticks() const;  ///< done so far
  [[nodiscard]] double dt() const;           ///< s, as asked for
  [[nodiscard]] double largestStep() const;  ///< s, really taken
  /// m/s: the largest speed with which particles and bodies can have met, as seen at the energy checks (every 64 steps,
  /// and wherever a run stops): of the fastest particle and the fastest body together. 0 in scenes without bodies.
  [[nodiscard]] double largestSpeed() const;
  [[nodiscard]] std::int64_t steps() const;
  [[nodiscard]] std::int64_t forceEvaluations() const;
  [[nodiscard]] int threads() const;
  [[nodiscard]] bool onDevice() const;              ///< whether a device moves the cloth in place of the processor
  [[nodiscard]] const Scene& scene() const;         ///< with the springs and the world that are in use
  [[nodiscard]] const Scene& startScene() const;    ///< as it began
  [[nodiscard]] const Sheet& sheet() const;         ///< as it is now, with its pins and what was cut
  [[nodiscard]] std::span<const int> held() const;  ///< the particles that hands hold, ascending; the sheet's pins too
  [[nodiscard]] int cuts() const;                   ///< how many cuts mend() could take back
  [[nodiscard]] const Method& method() const;
  [[nodiscard]] const EventLog& log() const;  ///< everything that happened since the start

  [[nodiscard]] Vec3 position(int particle) const;  ///< m
  [[nodiscard]] Vec3 velocity(int particle) const;  ///< m/s
  /// x, y, z of every particle in index order, for drawing; `xyz` holds 3 * count numbers.
  void copyPositions(std::span<float> xyz) const;
  /// The positions of now where a device has them, in the OpenGL context that draws; null where none does.
  [[nodiscard]] std::shared_ptr<const DevicePositions> positionsOnDevice() const;
  [[nodiscard]] std::uint64_t hash() const;  ///< of the positions, the velocities, and what cuts and tears have taken

  /// The energies now. This is an energy check as well: it never makes a later alarm less likely.
  Ledger ledger();
  /// What ledger() and then status() would say now, without an energy check: when the alarm goes does not depend on how
  /// often somebody looks.
  [[nodiscard]] Glance glance() const;
  [[nodiscard]] double checkedKinetic() const;  ///< energy, J, that the last energy check found
  /// Largest stable step (s) of the present method at the present state, damping included: infinite where nothing sets
  /// a limit, NaN where the method has none (rkc2, whose stages follow the sheet's waves, included) or the state is not
  /// finite. Costs at most four force evaluations, which are not counted, and leaves the motion alone. It follows one
  /// mode from call to call: called once a frame it is settled after about ten calls and is then within 1.5 % for
  /// symplectic Euler, leapfrog and imex; the first call is up to a tenth too large. For Runge-Kutta methods the
  /// mode's damping is taken along its own direction, which is as exact where one of stiffness and damping clearly sets
  /// the limit; explicit Euler's is that of the stiffest mode, and an upper bound.
  double liveStableStep();
  /// Checks the energies now; every 64 steps this happens by itself. The status, once bad, stays.
  Status check();
  [[nodiscard]] Status status() const;
  [[nodiscard]] double alarmTime() const;  ///< s at which the status turned bad; NaN while it is Ok

  [[nodiscard]] Snapshot save() const;
  /// Goes back to a checkpoint of this same simulation, its log and method included.
  void restore(const Snapshot& snapshot);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The state's hash as 16 hexadecimal digits.
std::string hashText(const Simulation& simulation);

}  // namespace tyg

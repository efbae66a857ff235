// The inside of a simulation: its parts, and what connects them. The parts have files of their own: backend.h (what
// moves), tick_clock.h, pushes.h, energy_watch.h, replay.h. Must not know: windows, files, clocks.
#pragma once

#include <memory>
#include <vector>

#include "core/simulation/backend.h"
#include "core/simulation/run.h"
#include "core/simulation/timetable.h"
#include "tyg/simulation.h"
#include "util/workers.h"

namespace tyg {

struct Simulation::Impl {
  Scene scene;
  const Scene startScene;
  Sheet sheet;  // as it is now: SheetChanges has the same
  Settings settings;
  Workers workers;
  std::unique_ptr<Backend> backend;
  Run run;
  std::function<bool()> observer;
  const Timetable timetable;
  bool stopAsked = false;
  bool finishing = false;    // a tick that is done whole even where the observer says stop
  double forcing = 0;        // J/s2, see Alarm::expect
  bool addsUpPower = false;  // the methods do, for the ledger or for a moving body's work

  Impl(Scene wanted, const Method& method, const Settings& asked);

  /// Everything that changes as time passes.
  struct Checkpoint {
    Run run;
    std::vector<Vec3> liveValues;
    std::unique_ptr<Backend::Checkpoint> moved;
  };
  [[nodiscard]] Checkpoint checkpoint() const;
  void goBackTo(const Checkpoint& checkpoint);
  [[nodiscard]] EnergySample sample() const { return sample(powerToSupply()); }
  /// `power` (W): of now, as powerToSupply() gives it.
  [[nodiscard]] EnergySample sample(const Power& power) const;
  void trackDissipation(bool on);
  /// To be called where the ledger begins or ends to be followed, and where a body begins or ends to move: what a body
  /// brings in a blow is over long before the next energy check, and has to be added up step by step.
  void followPower();
  [[nodiscard]] bool bodiesMove() const;
  [[nodiscard]] Instant now() const;
  /// W, where terms of the scene can bring energy; else 0.
  [[nodiscard]] Power powerToSupply() const;
  /// m/s, of the fastest particle and the fastest body together; 0 where nothing is touched.
  [[nodiscard]] double approach() const;
  /// An energy check at any time.
  void checkEnergies();
  /// To be called on both sides of a jump of that power.
  void checkSupply() { checkSupply(powerToSupply()); }
  void checkSupply(const Power& power);

  // simulation_steps.cpp
  void runTo(double end);
  void runTicks(std::int64_t count);

  // simulation_events.cpp
  /// Lets it happen now, and adds it to the log. `methods` is where the name of a method is looked up.
  void apply(const EventAction& action, std::span<const Method> methods);
  /// Throws InputError where the scene has nothing that a parameter is of, or where bodies do not allow the value.
  void refuseWithoutEffect(const Parameter& parameter, const Vec3& value) const;
  /// Makes the live parameters those of another scene.
  void useLiveParameters(Scene wanted);
  /// Lets pushes, winds and moving pins act on the backend anew.
  void applyPushes();
  void applyTimetable();
  /// The sheet is what run.changes says; what moves and pushes it learns that.
  void useSheet();

 private:
  void perform(const PushEvent& push, std::span<const Method> methods);
  void perform(const MethodEvent& change, std::span<const Method> methods);
  void perform(const StepEvent& change, std::span<const Method> methods);
  void perform(const WorldEvent& change, std::span<const Method> methods);
  void perform(const PinEvent& change, std::span<const Method> methods);
  void perform(const GrabEvent& grab, std::span<const Method> methods);
  void perform(const ReleaseEvent& release, std::span<const Method> methods);
  void perform(const CutEvent& cut, std::span<const Method> methods);
  void perform(const MendEvent& mend, std::span<const Method> methods);
  void refuseOutside(std::string_view event, int particle) const;
  void movePins();
  void cutWhatIsDue();
  [[nodiscard]] double ticksSoFar() const;
  [[nodiscard]] bool mayTearNow() const;
  void tearWhatIsTooLong();
  /// Lets the sheet lose springs, whose energy counts as dissipated.
  template <class Change>
  void lose(const Change& change);
  void applyDueEvents();

  /// Whether the method chooses its own steps. With tolerance 0 an adaptive method takes those of dt, for studies.
  [[nodiscard]] bool stepsFreely() const { return run.method->adaptive && scene.tolerance > 0; }
  [[nodiscard]] bool halted() const;
  [[nodiscard]] std::int64_t stepsToCheck() const;
  [[nodiscard]] std::int64_t stepsToQuestion() const;
  /// How many the methods may take before the alarm or the observer has to be asked.
  [[nodiscard]] std::int64_t stepsAtOnce() const;
  [[nodiscard]] double nextEdge(double end) const;
  [[nodiscard]] std::int64_t plainTicks(std::int64_t most) const;
  void switchWhatActs();
  void finishSteps(double h, int count, double timeAfter);
  void askObserver();
  void advance(std::int64_t steps, StepTimes times, double end);
  [[nodiscard]] double longestFreeStep() const;
  void advanceFreely(double stop);
  void advanceSegment(double stop);
  void runTick();
};

}  // namespace tyg

// The inside of a simulation, for the simulation_*.cpp alone: what it owns, and what they do for each other.
// Must not know: windows, files, clocks; what moves is in moving_sheet.cpp.
#pragma once

#include <cmath>
#include <memory>

#include "core/simulation/run.h"
#include "core/simulation/world.h"
#include "tyg/simulation.h"
#include "util/workers.h"

namespace tyg {

struct Simulation::Body {
  Scene scene;
  const Scene started;
  Sheet sheet;
  Settings settings;
  Workers workers;
  std::unique_ptr<MovingSheet> moving;
  Run run;
  std::span<const Method> replayMethods;
  std::function<bool()> observer;
  bool stopAsked = false;
  bool finishing = false;  // a tick that is done whole whoever asks to stop
  double forcing = 0;      // J/s2, see Alarm::expect

  Body(Scene wanted, const Method& method, const Settings& asked);

  /// Everything that changes as time passes.
  struct Saved {
    Run run;
    World world;
    std::unique_ptr<MovingSheet::Moment> moment;
  };
  [[nodiscard]] Saved save() const { return {run, worldOf(scene), moving->save()}; }
  void restore(const Saved& saved);

  // simulation_looks.cpp: energies and the alarm.
  static constexpr std::int64_t kStepsBetweenLooks = 64;
  [[nodiscard]] std::int64_t stepsToLook() const { return kStepsBetweenLooks - run.steps % kStepsBetweenLooks; }
  /// The energies now, which move the alarm.
  StoredEnergy look();
  [[nodiscard]] double work() const { return run.pushes.work(*moving); }
  [[nodiscard]] double ledgerSum(const StoredEnergy& energy) const;
  void followLedger(bool on);
  /// Accounts for `steps` steps of h that ended at `timeAfter`; they must not pass over a look.
  void count(double h, int steps, double timeAfter);
  [[nodiscard]] bool standing() const {
    return (stopAsked && !finishing) || run.stuck || (run.status != Status::Ok && !settings.keepGoing);
  }

  // simulation_walk.cpp: steps, from one stop time or tick to the next.
  /// Whether the method chooses its own steps. With tolerance 0 an adaptive method takes those of dt, for studies.
  [[nodiscard]] bool stepsFreely() const { return run.method->adaptive && scene.tolerance > 0; }
  [[nodiscard]] Pushes::Instant now() const;
  void switchPushes();
  void applyPushes();
  void walk(std::int64_t steps, double h, double end);
  void advanceSegment(double stop);
  void advance(double end);
  [[nodiscard]] double tickEnd(std::int64_t ahead) const;
  [[nodiscard]] std::int64_t plainTicks(std::int64_t most) const;
  void tick();
  void ticks(std::int64_t count);

  // simulation_edits.cpp: what a person, or a script of it, does between ticks.
  void note(LogEvent event);
  void push(int particle, const Vec3& force, int ticks);
  void useMethod(const Method& method);
  void useStep(double dt);
  void changeWorld(const LogEvent& event);
  [[nodiscard]] const Method& replayMethod(std::string_view name) const;
  void play(const LogEvent& event);
  void playScript();
};

}  // namespace tyg

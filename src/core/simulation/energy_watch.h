// Follows the energies of a run: the alarm, the balance of the ledger, the largest stretch. A regular type, so that a
// checkpoint is a copy. Must not know: where the energies come from, how steps are made.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "core/simulation/alarm.h"
#include "tyg/simulation.h"

namespace tyg {

/// Steps of a run from one energy check to the next, where nobody asks for one.
inline constexpr std::int64_t kStepsBetweenChecks = 64;

/// The energies of a run at one moment, J.
struct EnergySample {
  StoredEnergy stored{};
  double pushes = 0;  ///< put in by pushes so far
  Power passed{};     ///< what was lost, and what terms and pins have brought, so far
  Power judged{};     ///< the same as the alarm takes it
  double time = 0;    ///< s
};

class EnergyWatch {
 public:
  /// `start`: the energies of the start shape; `order` of the method. `followsLedger`: whether what is dissipated is
  /// followed from there.
  EnergyWatch(const Scene& scene, const Sheet& sheet, const StoredEnergy& start, int order, bool followsLedger)
      : alarm_(makeAlarm(scene, sheet, start, order)),
        start_(start),
        startSum_(start.withNaturalZero()),
        named_(namedIn(scene)),
        followsLedger_(followsLedger) {}

  /// An energy check: moves the alarm and the largest stretch.
  void check(const EnergySample& sample);
  /// The same with the energies as a caller gets them.
  Ledger ledger(const EnergySample& sample);
  /// See the functions of Alarm of these names.
  void useOrder(int order) { alarm_.useOrder(order); }
  void expect(double forcing, double h) { alarm_.expect(forcing, h); }
  void lose(double power, double time, Alarm::Taken taken) { alarm_.lose(power, time, taken); }
  [[nodiscard]] bool suspects() const { return alarm_.suspects(); }
  void sample(double power) { alarm_.sample(power); }

  /// From now on what is dissipated is followed, or no longer: the drift counts from here.
  void followLedger(bool on, const EnergySample& sample);
  [[nodiscard]] bool followsLedger() const { return followsLedger_; }

  /// Kinetic and all that is stored, J.
  [[nodiscard]] double mechanical(const StoredEnergy& energy) const { return energy.since(start_).sum(); }
  /// The live parameters have changed: what has no natural zero counts from `start`, the energies of the start shape as
  /// they would be now, and the alarm learns anew what a large energy is from the energies now.
  void begin(const Scene& scene, const Sheet& sheet, const StoredEnergy& start, const StoredEnergy& now);

  /// The steps have become too short to go on at all, at this time (s).
  void giveUp(double time);
  [[nodiscard]] bool gaveUp() const { return gaveUp_; }
  [[nodiscard]] Status status() const { return status_; }
  [[nodiscard]] double alarmTime() const { return alarmTime_; }  ///< s; NaN before the alarm
  [[nodiscard]] double kinetic() const { return kinetic_; }      ///< J, at the last energy check

 private:
  void turn(Status status, double time);
  [[nodiscard]] double sum(const EnergySample& sample) const;

  Alarm alarm_;
  Status status_ = Status::Ok;
  double alarmTime_ = std::numeric_limits<double>::quiet_NaN();
  bool gaveUp_ = false;
  double maxStretch_ = 0, kinetic_ = 0;
  /// What can store energy in a scene, and what can do work besides pushes.
  struct Named {
    std::array<bool, kStores.list.size()> stores{};
    std::array<bool, kSupplies.size()> supplies{};
    bool pins = false;
  };
  static Named namedIn(const Scene& scene);

  StoredEnergy start_;  // of the start shape
  double startSum_;     // J, of the ledger
  Named named_;
  bool followsLedger_;
};

}  // namespace tyg

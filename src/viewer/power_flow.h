// Power between the parts of a cloth, as the report's bond graph has them: sources (gravity, pushes) drive the masses,
// which exchange energy with the springs and lose it to the dampers. Must not know: how it is drawn, clocks.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "tyg/simulation.h"

namespace tyg {

/// W, on average over some time. Positive along the arrows of the graph.
class PowerFlow {
 public:
  struct Bond {
    std::string_view name;  ///< of what is at the other end: `gravity`
    double watts = 0;
  };

  /// Adds what drives the masses, or what takes energy from them.
  void addSource(const Bond& bond) { sources_.at(sourceCount_++) = bond; }
  void addSink(const Bond& bond) { sinks_.at(sinkCount_++) = bond; }
  void setKinetic(double watts) { kinetic_ = watts; }

  /// From each to the masses: what stores energy that counts from the start, and what does work.
  [[nodiscard]] std::span<const Bond> sources() const { return std::span(sources_).first(sourceCount_); }
  /// From the masses to each: what else stores energy, and last all that damps.
  [[nodiscard]] std::span<const Bond> sinks() const { return std::span(sinks_).first(sinkCount_); }
  [[nodiscard]] double kinetic() const { return kinetic_; }  ///< what stays in the masses
  /// What the method loses or makes up: the balance of all others.
  [[nodiscard]] double missing() const;

 private:
  std::array<Bond, 2 * Energies::kMost> sources_{};
  std::array<Bond, Energies::kMost + 1> sinks_{};
  std::size_t sourceCount_ = 0, sinkCount_ = 0;
  double kinetic_ = 0;
};

/// Between two ledgers of one run, `seconds` (> 0) apart, that follow the dissipation.
PowerFlow powerBetween(const Ledger& before, const Ledger& after, double seconds);

}  // namespace tyg

// A motion that another program wrote, as the ghost of the live cloth: where its particles are at any time, and how far
// the live cloth was from it at its samples. Must not know: files, windows, what is found out about the motion.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "study/check/motion_rows.h"
#include "tyg/simulation.h"

namespace tyg {

/// How far the live cloth was from a given motion at one of the motion's samples.
struct SampleGap {
  double time = 0;     ///< s, of the sample
  double rms = 0;      ///< m, over all particles
  double largest = 0;  ///< m, of any particle
};

class GivenGhost {
 public:
  /// Before its first sample a motion is nowhere; after its last one it stays where it was.
  enum class Place { Before, Within, After };

  /// `scene`: the one that the motion is of.
  GivenGhost(std::shared_ptr<const GivenMotion> motion, const Scene& scene);

  /// Goes to the live cloth's time (s): between two samples along a smooth curve through them. Allocates nothing.
  void moveTo(double time);
  /// To be called before ticks: measures where the live cloth is at a sample, or will be within half a tick. Returns
  /// how many ticks it is to the next sample, 1 at least. Allocates nothing.
  std::int64_t meet(const Simulation& live);

  [[nodiscard]] const GivenMotion& motion() const { return *motion_; }
  [[nodiscard]] const Sheet& sheet() const { return sheet_; }  ///< with its pins
  [[nodiscard]] Place place() const { return place_; }
  [[nodiscard]] double interval() const { return interval_; }  ///< s, the longest between two samples
  /// Its x, y, z at that time, m.
  [[nodiscard]] std::span<const float> positions() const { return positions_; }
  /// Of the last sample that was met; none since the last start.
  [[nodiscard]] const std::optional<SampleGap>& gap() const { return gap_; }
  /// Whether the two were farther apart there than rounding takes two programs that do the same.
  [[nodiscard]] bool differs() const;
  /// The distance of each particle at that sample, m.
  [[nodiscard]] std::span<const float> distances() const { return distances_; }

 private:
  [[nodiscard]] Vec3 slopeAt(std::size_t sample, std::size_t particle) const;
  void interpolate(std::size_t next, double time);
  void measure(const Simulation& live, std::size_t sample);

  std::shared_ptr<const GivenMotion> motion_;
  Sheet sheet_;
  Place place_ = Place::Before;
  double interval_ = 0;
  std::optional<SampleGap> gap_;
  std::vector<float> positions_, distances_;
};

}  // namespace tyg

// The table of runs past their horizon, and sentences that sum them up precision by precision.
#include "study/work/past_horizon.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "util/csv.h"

namespace tyg {
namespace {

constexpr std::array kPrecisions{Precision::Double, Precision::Float};

/// Larger of the two, part by part.
BulkDistance larger(const BulkDistance& a, const BulkDistance& b) {
  return {std::max(a.centre, b.centre), std::max(a.gyration, b.gyration), std::max(a.energy, b.energy)};
}

}  // namespace

std::string pastHorizonCsv(const std::vector<PastHorizon>& runs) {
  std::string csv = csvLine("scene", "integrator", "precision", "dt", "tolerance", "horizon_s", "centre_m",
                            "centre_band_m", "gyration_m", "gyration_band_m", "energy_J", "energy_band_J");
  for (const auto& [row, distance, band] : runs) {
    csv += csvLine(row.scene, row.integrator, nameOf(row.precision), longNumber(row.dt), longNumber(row.tolerance),
                   longNumber(row.horizon), longNumber(distance.centre), longNumber(band.centre),
                   longNumber(distance.gyration), longNumber(band.gyration), longNumber(distance.energy),
                   longNumber(band.energy));
  }
  return csv;
}

std::vector<std::string> pastHorizonLines(const std::vector<PastHorizon>& runs) {
  std::vector<std::string> lines;
  for (const Precision precision : kPrecisions) {
    BulkDistance most, band;
    int count = 0, centres = 0, gyrations = 0, energies = 0;
    for (const PastHorizon& run : runs) {
      if (run.row.precision != precision) continue;
      ++count;
      centres += run.distance.centre <= run.band.centre ? 1 : 0;
      gyrations += run.distance.gyration <= run.band.gyration ? 1 : 0;
      energies += run.distance.energy <= run.band.energy ? 1 : 0;
      most = larger(most, run.distance);
      band = larger(band, run.band);
    }
    if (count == 0) continue;
    const auto part = [&](const char* what, double distance, const char* unit, int within, double spread) {
      return fmt::format("{} up to {:.2g} {} away ({} within the twin's {:.2g} {})", what, distance, unit, within,
                         spread, unit);
    };
    lines.push_back(fmt::format("{} in {} past the horizon, where whole cloths are compared: {}, {}, {}",
                                count == 1 ? "1 run goes" : fmt::format("{} runs go", count), nameOf(precision),
                                part("centre of mass", most.centre, "m", centres, band.centre),
                                part("gyration radius", most.gyration, "m", gyrations, band.gyration),
                                part("energy", most.energy, "J", energies, band.energy)));
  }
  return lines;
}

std::vector<std::string> horizonLines(const std::vector<WorkRow>& rows, double duration) {
  std::vector<std::string> lines;
  for (const Precision precision : kPrecisions) {
    int count = 0, all = 0;
    double first = duration, last = 0;
    for (const WorkRow& row : rows) {
      if (row.precision != precision || row.status != RowStatus::Ok) continue;
      ++all;
      if (row.trusted(duration)) continue;
      ++count;
      first = std::min(first, row.horizon);
      last = std::max(last, row.horizon);
    }
    if (count == 0) continue;
    const std::string to = last > first ? fmt::format(" to {:.3g}", last) : "";
    const std::string from =
        last > 0 ? fmt::format("from T* = {:.3g}{} s of {:.3g} s on", first, to, duration) : "from the start";
    lines.push_back(
        fmt::format("{} of {} {} in {} {}", count, all, all == 1 ? "run" : "runs", nameOf(precision), from));
  }
  return lines;
}

}  // namespace tyg

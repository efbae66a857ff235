// Words and numbers about horizons.
#include "study/motion/past_horizon.h"

#include <algorithm>
#include <array>
#include <iomanip>
#include <sstream>

namespace tyg {
namespace {

constexpr std::array kPrecisions{Precision::Double, Precision::Float};

/// Larger of the two, part by part.
BulkDistance larger(const BulkDistance& a, const BulkDistance& b) {
  return {std::max(a.centre, b.centre), std::max(a.gyration, b.gyration), std::max(a.energy, b.energy)};
}

}  // namespace

std::string pastHorizonCsv(const std::vector<PastHorizon>& runs) {
  std::ostringstream csv;
  csv << "scene,integrator,precision,dt,tolerance,horizon_s,centre_m,centre_band_m,gyration_m,gyration_band_m,energy_J,"
         "energy_band_J\n"
      << std::setprecision(17);
  for (const PastHorizon& run : runs) {
    csv << csvField(run.row.scene) << "," << run.row.integrator << "," << nameOf(run.row.precision) << "," << run.row.dt
        << "," << run.row.tolerance << "," << run.row.horizon << "," << run.distance.centre << "," << run.band.centre
        << "," << run.distance.gyration << "," << run.band.gyration << "," << run.distance.energy << ","
        << run.band.energy << "\n";
  }
  return csv.str();
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
    std::ostringstream text;
    text << std::setprecision(2) << "past the horizon of " << count << (count == 1 ? " run in " : " runs in ")
         << nameOf(precision) << ", distance from the reference (a twin's; runs within it): centre of mass "
         << most.centre << " m (" << band.centre << "; " << centres << "), gyration radius " << most.gyration << " m ("
         << band.gyration << "; " << gyrations << "), energy " << most.energy << " J (" << band.energy << "; "
         << energies << ")";
    lines.push_back(text.str());
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
    std::ostringstream text;
    text << std::setprecision(3) << "in " << nameOf(precision) << " T* = " << first;
    if (last > first) text << " to " << last;
    text << " s of " << duration << " s for " << count << " of " << all << (all == 1 ? " run" : " runs");
    lines.push_back(text.str());
  }
  return lines;
}

}  // namespace tyg

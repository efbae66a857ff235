// Rows go into a temporary file as they come, which gets its name when the run is complete.
#include "app/output/sample_file.h"

#include <string>

#include "util/csv.h"

namespace tyg {

SampleFile::SampleFile(const std::filesystem::path& path) : file_(path) {
  file_.write(csvLine("t", "particle", "x", "y", "z", "vx", "vy", "vz"));
}

void SampleFile::add(const Simulation& simulation) {
  constexpr std::size_t kAtOnce = std::size_t{1} << 20U;  // bytes
  const std::string time = longNumber(simulation.time());
  std::string rows;
  for (int particle = 0; particle < simulation.sheet().count(); ++particle) {
    const Vec3 x = simulation.position(particle), v = simulation.velocity(particle);
    rows += csvLine(time, particle, longNumber(x.x), longNumber(x.y), longNumber(x.z), longNumber(v.x), longNumber(v.y),
                    longNumber(v.z));
    if (rows.size() < kAtOnce) continue;
    file_.write(rows);
    rows.clear();
  }
  file_.write(rows);
}

void SampleFile::keep() { file_.keep(); }

}  // namespace tyg

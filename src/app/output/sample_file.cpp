// Rows are written as they come into a temporary file, which gets its name when the run is complete.
#include "app/output/sample_file.h"

#include <string>

#include "util/csv.h"

namespace tyg {

SampleFile::SampleFile(const std::filesystem::path& path)
    : path_(path), file_(path), stream_(file_.temporary(), std::ios::binary) {
  stream_ << csvLine("t", "particle", "x", "y", "z", "vx", "vy", "vz");
}

void SampleFile::add(const Simulation& simulation) {
  const std::string time = longNumber(simulation.time());
  for (int particle = 0; particle < simulation.sheet().count(); ++particle) {
    const Vec3 x = simulation.position(particle), v = simulation.velocity(particle);
    stream_ << csvLine(time, particle, longNumber(x.x), longNumber(x.y), longNumber(x.z), longNumber(v.x),
                       longNumber(v.y), longNumber(v.z));
  }
}

void SampleFile::keep() {
  stream_.close();
  if (!stream_)
    throw InputError("cannot write '" + path_.string() + "': the disk is full or failed while it was written");
  file_.keep();
}

}  // namespace tyg

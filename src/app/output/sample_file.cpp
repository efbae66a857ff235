// Samples as CSV.
#include "app/output/sample_file.h"

#include <string>

#include "util/text.h"

namespace tyg {

SampleFile::SampleFile(const std::filesystem::path& path)
    : path_(path), file_(path), stream_(file_.temporary(), std::ios::binary) {
  stream_ << "t,particle,x,y,z,vx,vy,vz\n";
}

void SampleFile::add(const Simulation& simulation) {
  const std::string time = longNumber(simulation.time());
  std::string row;
  for (int particle = 0; particle < simulation.sheet().count(); ++particle) {
    const Vec3 position = simulation.position(particle), velocity = simulation.velocity(particle);
    row = time + "," + std::to_string(particle);
    for (const double number : {position.x, position.y, position.z, velocity.x, velocity.y, velocity.z}) {
      row.append(",").append(longNumber(number));
    }
    stream_ << row << '\n';
  }
}

void SampleFile::keep() {
  stream_.close();
  if (!stream_)
    throw InputError("cannot write '" + path_.string() + "': the disk is full or failed while it was written");
  file_.keep();
}

}  // namespace tyg

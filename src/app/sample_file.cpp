// Samples as CSV.
#include "app/sample_file.h"

#include <array>
#include <charconv>
#include <string>

namespace tyg {
namespace {

/// 17 significant digits: every double reads back as itself.
void append(std::string& row, double number) {
  std::array<char, 40> digits{};
  const auto end = std::to_chars(digits.begin(), digits.end(), number, std::chars_format::general, 17).ptr;
  row.append(",").append(digits.begin(), end);
}

}  // namespace

SampleFile::SampleFile(const std::filesystem::path& path)
    : path_(path), file_(path), stream_(file_.temporary(), std::ios::binary) {
  stream_ << "t,particle,x,y,z,vx,vy,vz\n";
}

void SampleFile::add(const Simulation& simulation) {
  std::string time;
  append(time, simulation.time());
  time.erase(0, 1);
  std::string row;
  for (int particle = 0; particle < simulation.sheet().count(); ++particle) {
    const Vec3 position = simulation.position(particle), velocity = simulation.velocity(particle);
    row = time + "," + std::to_string(particle);
    for (const double number : {position.x, position.y, position.z, velocity.x, velocity.y, velocity.z}) {
      append(row, number);
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

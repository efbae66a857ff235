// The samples of `tyg run --out`: every particle at chosen times, as CSV, whole or not at all.
// Must not know: which times, how they came about.
#pragma once

#include <filesystem>

#include "tyg/simulation.h"
#include "util/whole_file.h"

namespace tyg {

class SampleFile {
 public:
  /// Throws InputError where the file cannot be written, before anything is computed.
  explicit SampleFile(const std::filesystem::path& path);
  /// One row a particle: `t,particle,x,y,z,vx,vy,vz` with 17 significant digits (s, m, m/s).
  void add(const Simulation& simulation);
  /// All rows are there: the file appears under its name. Throws InputError where they could not be written.
  void keep();

 private:
  WholeFile file_;
};

}  // namespace tyg

// A motion as CSV, in either of the forms that `tyg check` reads, whole or not at all.
// Must not know: how the motion came about.
#pragma once

#include <filesystem>
#include <vector>

#include "tyg/scene.h"
#include "util/whole_file.h"

namespace tyg {

/// Long: `t,particle,x,y,z` and a row for every particle and time. Wide: `t,x0,y0,z0,x1,...` and a row for every time.
enum class MotionForm { Long, Wide };

class MotionFile {
 public:
  /// Throws InputError where the file cannot be written, before anything is computed.
  MotionFile(const std::filesystem::path& path, MotionForm form, int particles);
  /// The positions (m) of all particles at a time (s), with 17 significant digits.
  void add(double time, const std::vector<Vec3>& positions);
  /// All times are there: the file appears under its name. Throws InputError where they could not be written.
  void keep() { file_.keep(); }

 private:
  WholeFile file_;
  MotionForm form_;
};

}  // namespace tyg

// One time after the other goes into a temporary file, which gets its name at the end.
#include "app/output/motion_file.h"

#include <string>

#include <fmt/core.h>

#include "util/csv.h"

namespace tyg {

MotionFile::MotionFile(const std::filesystem::path& path, MotionForm form, int particles) : file_(path), form_(form) {
  std::string header = form == MotionForm::Long ? "t,particle,x,y,z" : "t";
  for (int particle = 0; form == MotionForm::Wide && particle < particles; ++particle) {
    header += fmt::format(",x{0},y{0},z{0}", particle);
  }
  file_.write(header + "\n");
}

void MotionFile::add(double time, const std::vector<Vec3>& positions) {
  const std::string t = longNumber(time);
  std::string rows = form_ == MotionForm::Wide ? t : "";
  for (std::size_t particle = 0; particle < positions.size(); ++particle) {
    const Vec3& at = positions[particle];
    const std::string x = longNumber(at.x), y = longNumber(at.y), z = longNumber(at.z);
    rows += form_ == MotionForm::Long ? csvLine(t, particle, x, y, z) : fmt::format(",{},{},{}", x, y, z);
  }
  file_.write(form_ == MotionForm::Wide ? rows + "\n" : rows);
}

}  // namespace tyg

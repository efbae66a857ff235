// A motion that another program wrote as CSV: times and positions, checked row by row, and how finely they are printed.
// Must not know: files, which method or mistake the motion may hold.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "tyg/scene.h"

namespace tyg {

/// A motion of a scene's sheet as it was handed in.
struct GivenMotion {
  std::vector<double> times;                 ///< s, ascending, >= 0
  std::vector<std::vector<Vec3>> positions;  ///< m; by time, then particle
  std::vector<double> rounding;              ///< m, by time: the largest distance that one unit of the last digit makes
  double timeRounding = 0;                   ///< s: the same of the latest time
};

/// Reads the text of `fileName`. Long form: a header that names at least t, particle, x, y, z in any order, one row a
/// particle and time in any order; wide form: t, x0, y0, z0, x1, ... and one row a time. SI units; blank lines and
/// lines that begin with # are passed over. Throws InputError with line, column, what was found and what is allowed:
/// also where the particles are not those of the scene's sheet or do not start where its particles do, and where times
/// or positions are in other units.
GivenMotion readMotion(std::string_view text, const std::string& fileName, const Scene& scene);

/// The steps (s) with which a program may have come to all of these times, counted from 0: the longest first, and whole
/// parts of the longest. `usual` are others to be tried where they fit. None where the times are on no grid.
std::vector<double> stepsOnto(const GivenMotion& motion, const std::vector<double>& usual);
/// How many steps of dt (s) lead to each time; empty where one of them falls between two steps.
std::vector<std::int64_t> stepCounts(const GivenMotion& motion, double dt);

}  // namespace tyg

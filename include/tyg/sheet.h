// The sheet at rest that a scene describes: how many particles, where they start, which are pinned, which springs join
// them. Third of the headers to read. Must not know: the moving state, forces, methods.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "tyg/scene.h"

namespace tyg {

/// A grid of equal particles. Particle (column c, row r) has the index r * columns + c; row 0 is at the top or back.
struct Sheet {
  int columns = 1, rows = 1;
  double spacing = 1;       ///< m
  double particleMass = 1;  ///< kg
  Start start = Start::Hanging;
  std::vector<int> pins;  ///< indices of the pinned particles, ascending, each once

  [[nodiscard]] int count() const { return columns * rows; }
  /// The larger of (columns-1)*spacing and (rows-1)*spacing, m; spacing itself for a single particle.
  [[nodiscard]] double size() const;
  /// Position of a particle in the start shape, before displacements, m.
  [[nodiscard]] Vec3 startPosition(int particle) const;
};

/// The sheet of a scene. Throws InputError where a pin lies outside.
Sheet makeSheet(const Scene& scene);

/// The names of single particles: `top-left` and so on.
std::span<const std::string_view> particleNames();
/// Whether a word names a particle or a set of them.
bool isPlaceName(std::string_view word);
/// The index of the one particle that `place` names. Throws InputError for an unknown name, a set, or a place outside.
int particleAt(const Sheet& sheet, const Place& place);
/// The indices that `place` names: one particle, or a set (`top`, `left`, `corners`). Throws InputError.
std::vector<int> particlesAt(const Sheet& sheet, const Place& place);

enum class Family { Structural, Shear, Bend };
/// One spring as a pair of particles (for drawing and for tests: the forces use no such list).
struct SpringEnds {
  int first, second;
};
/// Every spring of a family once: structural (c+1,r), (c,r+1); shear (c+1,r+1), (c-1,r+1); bend (c+2,r), (c,r+2).
std::vector<SpringEnds> springsOf(const Sheet& sheet, Family family);
/// How many springs a family has, without listing them.
long long springCount(const Sheet& sheet, Family family);
/// Rest length of a family's springs, m: spacing, spacing*sqrt(2), 2*spacing.
double restLength(const Sheet& sheet, Family family);

}  // namespace tyg

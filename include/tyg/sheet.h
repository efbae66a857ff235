// The sheet at rest that a scene describes: how many particles, where they start, which are pinned, which springs join
// them. Third of the headers to read. Must not know: the moving state, forces, methods.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "tyg/scene.h"

namespace tyg {

/// Which springs and cells of a sheet are gone, bit by bit for the particle that they belong to. Most sheets have none.
class Missing {
 public:
  /// Of particle (c, r): the springs to (c+1, r) and (c, r+1); the two diagonals of the cell right and below, from
  /// (c, r) and from (c+1, r); the bend springs to (c+2, r) and (c, r+2); and that cell.
  enum Bit : std::uint8_t {
    Right = 1,
    Down = 2,
    DownRight = 4,
    DownLeft = 8,
    Right2 = 16,
    Down2 = 32,
    Cell = 64,
  };

  [[nodiscard]] bool none() const { return !bits_; }
  [[nodiscard]] bool has(int particle, Bit bit) const { return bits_ && ((*bits_)[std::size_t(particle)] & bit) != 0; }
  /// Whether anything of the row that begins with this particle is gone.
  [[nodiscard]] bool anyIn(int firstParticle, int columns) const;
  /// The same and what a cut takes: a spring whose ends stand on different sides of the cut's line, where the cut's
  /// ends are not strictly on one side of the spring's line. A particle on the line counts towards larger columns, on a
  /// cut along a row towards larger rows. A cell goes with any of its diagonals, whether or not these are springs.
  [[nodiscard]] Missing withCut(int columns, int rows, const CutLine& cut) const;
  /// A state's hash, and what is gone: the same where nothing is.
  [[nodiscard]] std::uint64_t mixedInto(std::uint64_t hash) const;
  bool operator==(const Missing& other) const;

 private:
  std::shared_ptr<const std::vector<std::uint8_t>> bits_;  ///< by particle; null: nothing is gone
};

/// A grid of equal particles. Particle (column c, row r) has the index r * columns + c; row 0 is at the top or back.
struct Sheet {
  int columns = 1, rows = 1;
  double spacing = 1;       ///< m
  double particleMass = 1;  ///< kg
  Start start = Start::Hanging;
  std::vector<int> pins;  ///< indices of the pinned particles, ascending, each once
  Missing missing{};      ///< what cuts and tears have taken

  [[nodiscard]] int count() const { return columns * rows; }
  /// The larger of (columns-1)*spacing and (rows-1)*spacing, m; spacing itself for a single particle.
  [[nodiscard]] double size() const;
  /// Position of a particle in the start shape, before displacements, m.
  [[nodiscard]] Vec3 startPosition(int particle) const;
  bool operator==(const Sheet&) const = default;
};

/// The sheet of a scene. Throws InputError where a pin lies outside.
Sheet makeSheet(const Scene& scene);

/// The names of single particles: `top-left` and so on.
std::span<const std::string_view> particleNames();
/// Whether a word names a particle or a set of them.
bool isPlaceName(std::string_view word);
/// The names of single particles and of sets.
std::span<const std::string_view> placeNames();
/// The index of the one particle that `place` names. Throws InputError for an unknown name, a set, or a place outside.
int particleAt(const Sheet& sheet, const Place& place);
/// The indices that `place` names: one particle, or a set (`top`, `left`, `corners`). Throws InputError.
std::vector<int> particlesAt(const Sheet& sheet, const Place& place);

enum class Family { Structural, Shear, Bend };
/// One spring as a pair of particles (for drawing and for tests: the forces use no such list).
struct SpringEnds {
  int first, second;
};
/// Every spring of a family that is there, once: structural (c+1,r), (c,r+1); shear (c+1,r+1), (c-1,r+1); bend (c+2,r),
/// (c,r+2).
std::vector<SpringEnds> springsOf(const Sheet& sheet, Family family);
/// How many springs a family has, without listing them.
long long springCount(const Sheet& sheet, Family family);
/// Rest length of a family's springs, m: spacing, spacing*sqrt(2), 2*spacing.
double restLength(const Sheet& sheet, Family family);

}  // namespace tyg

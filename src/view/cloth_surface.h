// A sheet as a surface to draw: triangles between its particles, normals, and what is shown beside cuts and tears.
// Must not know: OpenGL, light, colours.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "tyg/sheet.h"

namespace tyg {

/// A corner of a triangle beside a cut.
struct ClothVertex {
  glm::vec3 position;      ///< m
  glm::vec3 normal;        ///< of any length
  glm::vec2 place;         ///< on the sheet: column and row, also between particles
  std::uint32_t particle;  ///< whose colour it has
};

/// Cells without a cut are two triangles between particles each. A cell that lost one of its four sides is drawn once
/// for each part of it that still hangs together: to the middles of its lost sides, which are extrapolated from the
/// part's own particles (Molino, Bao and Fedkiw 2004). So a cut opens as two edges, and nothing joins
/// parts that have come apart.
class ClothSurface {
 public:
  enum Way { Right, Down, Left, Up };  ///< in the order of the sides of a cell

  explicit ClothSurface(const Sheet& sheet);

  /// Whether a sheet has cells; a chain has none.
  static bool possible(const Sheet& sheet) { return sheet.columns > 1 && sheet.rows > 1; }

  /// Particle numbers, three for each triangle of the cells without a cut; counterclockwise as seen from where their
  /// normals point.
  [[nodiscard]] const std::vector<std::uint32_t>& triangles() const { return triangles_; }

  /// The surface of particles that are here now: x, y, z of each, m. Allocates nothing when it is called again.
  void follow(std::span<const float> xyz);
  /// Of every particle, of any length: the sum of the areas of the cells around it, as vectors.
  [[nodiscard]] const std::vector<glm::vec3>& normals() const { return normals_; }
  /// Beside cuts, three for each triangle, in the same sense.
  [[nodiscard]] const std::vector<ClothVertex>& pieces() const { return pieces_; }

  /// Where a particle is, m.
  [[nodiscard]] glm::vec3 at(int particle) const;
  /// The particle on this side; to be asked for only where there is one.
  [[nodiscard]] int neighbour(int particle, Way way) const;
  /// Whether there is a particle on this side and the spring to it.
  [[nodiscard]] bool joined(int particle, Way way) const;
  /// From a particle to where its lost neighbour on this side would be, m.
  [[nodiscard]] glm::vec3 beyond(int particle, Way way) const;

 private:
  struct Cell;

  [[nodiscard]] ClothVertex corner(int particle) const;
  [[nodiscard]] ClothVertex end(int particle, Way way) const;
  void addWholeNormals();
  void addNormals(const Cell& cell);
  void addPieces(const Cell& cell);
  void addFan(std::span<const ClothVertex> corners, std::size_t middle);

  Sheet sheet_;
  std::vector<std::uint32_t> triangles_;
  std::vector<int> cut_;  ///< first particles of cells with a lost side
  std::span<const float> xyz_;
  std::vector<glm::vec3> normals_;
  std::vector<ClothVertex> pieces_;
};

/// The strain of each particle, into `strains`: of the most strained of its structural springs. `xyz` holds x, y, z of
/// every particle, m.
void particleStrains(const Sheet& sheet, std::span<const float> xyz, std::vector<float>& strains);

}  // namespace tyg

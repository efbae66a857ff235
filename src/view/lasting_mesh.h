// A sheet as one mesh of quads that stay the same while the sheet is cut and torn, as other programs want a mesh that
// moves: only points move. Must not know: files, OpenGL, why springs go.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "view/cloth_surface.h"

namespace tyg {

/// A cell that keeps its four sides is one quad. A cell that loses one is four quads from the start, one at each
/// corner, whose points lie together as long as the side is there; then they move apart, as ClothSurface draws cuts.
class LastingMesh {
 public:
  /// `last`: the sheet when nothing goes any more.
  explicit LastingMesh(const Sheet& last);

  /// Point numbers, counterclockwise as seen from where the normals point; none of a chain.
  [[nodiscard]] const std::vector<std::array<std::uint32_t, 4>>& quads() const { return quads_; }
  /// Of every point: column and row, also between particles. The first points are the particles.
  [[nodiscard]] const std::vector<glm::vec2>& places() const { return places_; }

  /// The points of a sheet that is now this one, at an earlier time or as it was given, with its particles here: x, y,
  /// z of each, m.
  void follow(const Sheet& now, std::span<const float> xyz);
  [[nodiscard]] const std::vector<glm::vec3>& points() const { return points_; }
  [[nodiscard]] const std::vector<glm::vec3>& normals() const { return normals_; }  ///< of length 1, or 0

 private:
  using Way = ClothSurface::Way;
  static constexpr std::size_t kCorners = 4;
  /// The middle of a side of a cell, as the particle sees it.
  struct SideMiddle {
    int particle;
    Way way;
  };
  /// The middle of a cell, as one of its corners sees it.
  struct CellMiddle {
    int first;           ///< particle of the cell
    std::size_t corner;  ///< 0..3, around the cell as in ClothSurface
  };

  void addCell(int first);
  std::uint32_t sideMiddle(int particle, Way way);
  std::uint32_t addPoint(const glm::vec2& place);
  [[nodiscard]] std::array<int, kCorners> cornersOf(int first) const;
  [[nodiscard]] std::array<bool, kCorners> lostSides(int first) const;
  [[nodiscard]] glm::vec3 positionOf(const SideMiddle& middle) const;
  [[nodiscard]] glm::vec3 positionOf(const CellMiddle& middle) const;

  std::vector<std::array<std::uint32_t, 4>> quads_;
  std::vector<glm::vec2> places_;
  std::map<std::pair<int, Way>, std::uint32_t> numbers_;  ///< of middles of sides
  std::vector<std::pair<std::uint32_t, SideMiddle>> sideMiddles_;
  std::vector<std::pair<std::uint32_t, CellMiddle>> cellMiddles_;
  Sheet sheet_;
  ClothSurface surface_;
  std::vector<glm::vec3> points_, normals_;
};

}  // namespace tyg

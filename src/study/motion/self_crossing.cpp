// Triangles are listed by the boxes of a regular grid that they reach into, sorted; an edge then meets only the
// triangles of its own boxes. The boxes are as wide as the longest edge usually is, so that each triangle reaches into
// a few.
#include "study/motion/self_crossing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <vector>

namespace tyg {
namespace {

Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// Six times the volume of the tetrahedron; its sign tells on which side of the plane abc the point d lies.
double volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) { return dot(cross(b - a, c - a), d - a); }

using Triangle = std::array<int, 3>;  // particles
using Edge = std::array<int, 2>;
using Box = std::array<std::int32_t, 3>;

class Crossings {
 public:
  Crossings(const Sheet& sheet, std::span<const Vec3> positions) : sheet_(sheet), at_(positions) {
    width_ = boxWidth();
    for (int cell = 0; cell < cells(); ++cell) {
      if (isCut(cell)) continue;
      for (const Triangle& triangle : trianglesOf(cell)) {
        forBoxes(triangle, [&](const Box& box) { entries_.push_back({box, cell}); });
      }
    }
    std::sort(entries_.begin(), entries_.end());
  }

  [[nodiscard]] std::optional<CrossingCells> first() const {
    for (int cell = 0; cell < cells(); ++cell) {
      if (isCut(cell)) continue;
      std::optional<int> other;
      for (const Edge& edge : edgesOf(cell)) {
        forBoxes(edge, [&](const Box& box) {
          auto entry = std::ranges::lower_bound(entries_, box, {}, &Entry::box);
          for (; entry != entries_.end() && entry->box == box; ++entry) {
            if ((!other || entry->cell < *other) && !touch(cell, entry->cell) && pierces(edge, entry->cell)) {
              other = entry->cell;
            }
          }
        });
      }
      if (other) return CrossingCells{columnOf(cell), rowOf(cell), columnOf(*other), rowOf(*other)};
    }
    return std::nullopt;
  }

 private:
  struct Entry {
    Box box;
    int cell;
    bool operator<(const Entry& other) const { return std::tie(box, cell) < std::tie(other.box, other.cell); }
  };

  [[nodiscard]] int across() const { return sheet_.columns - 1; }
  [[nodiscard]] int cells() const { return across() * (sheet_.rows - 1); }
  [[nodiscard]] int columnOf(int cell) const { return cell % across(); }
  [[nodiscard]] int rowOf(int cell) const { return cell / across(); }
  [[nodiscard]] bool touch(int a, int b) const {
    return std::abs(columnOf(a) - columnOf(b)) <= 1 && std::abs(rowOf(a) - rowOf(b)) <= 1;
  }
  [[nodiscard]] bool isCut(int cell) const { return sheet_.missing.has(corner(cell), Missing::Cell); }
  [[nodiscard]] int corner(int cell) const { return rowOf(cell) * sheet_.columns + columnOf(cell); }
  [[nodiscard]] std::array<Triangle, 2> trianglesOf(int cell) const {
    const int a = corner(cell), b = a + 1, e = a + sheet_.columns, f = e + 1;
    return {{{a, b, e}, {b, f, e}}};
  }
  [[nodiscard]] std::array<Edge, 5> edgesOf(int cell) const {
    const int a = corner(cell), b = a + 1, e = a + sheet_.columns, f = e + 1;
    return {{{a, b}, {a, e}, {b, e}, {b, f}, {e, f}}};
  }
  [[nodiscard]] const Vec3& at(int particle) const { return at_[std::size_t(particle)]; }

  /// Half as much again as the mean edge of the present shape, and not so little that a box's number overflows.
  [[nodiscard]] double boxWidth() const {
    double sum = 0, farthest = 0;
    int count = 0;
    for (int cell = 0; cell < cells(); ++cell) {
      const Vec3 d = at(corner(cell) + 1) - at(corner(cell));
      if (const double length = std::sqrt(dot(d, d)); std::isfinite(length)) sum += length, ++count;
    }
    for (const Vec3& p : at_) {
      const double size = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
      if (std::isfinite(size)) farthest = std::max(farthest, size);
    }
    constexpr double kMostBoxes = 1e9;
    return std::max({count > 0 ? 1.5 * sum / count : 0, farthest / kMostBoxes, 1e-300});
  }

  /// The boxes that the corners' bounds reach into. One that has been stretched over more than a few hundred is left
  /// out: it is no cloth any more.
  template <std::size_t n, class Visit>
  void forBoxes(const std::array<int, n>& corners, const Visit& visit) const {
    constexpr double kMost = 512;
    std::array<double, 3> low{}, high{};
    for (std::size_t k = 0; k < n; ++k) {
      const Vec3& p = at(corners[k]);
      const std::array<double, 3> box{std::floor(p.x / width_), std::floor(p.y / width_), std::floor(p.z / width_)};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = k == 0 ? box[axis] : std::min(low[axis], box[axis]);
        high[axis] = k == 0 ? box[axis] : std::max(high[axis], box[axis]);
      }
    }
    double count = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) count *= high[axis] - low[axis] + 1;
    if (!(count <= kMost)) return;
    for (double x = low[0]; x <= high[0]; ++x) {
      for (double y = low[1]; y <= high[1]; ++y) {
        for (double z = low[2]; z <= high[2]; ++z) visit({std::int32_t(x), std::int32_t(y), std::int32_t(z)});
      }
    }
  }

  [[nodiscard]] bool pierces(const Edge& edge, int cell) const {
    const auto [first, second] = trianglesOf(cell);
    return pierces(edge, first) || pierces(edge, second);
  }
  /// The ends lie on two sides of the plane, and the edge passes all sides of the triangle on the same side of them.
  [[nodiscard]] bool pierces(const Edge& edge, const Triangle& triangle) const {
    const Vec3 &a = at(triangle[0]), &b = at(triangle[1]), &c = at(triangle[2]), &p = at(edge[0]), &q = at(edge[1]);
    if (!(volume(a, b, c, p) * volume(a, b, c, q) < 0)) return false;
    const double ab = volume(p, q, a, b), bc = volume(p, q, b, c), ca = volume(p, q, c, a);
    return (ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0);
  }

  const Sheet& sheet_;
  std::span<const Vec3> at_;
  double width_ = 1;  // m
  std::vector<Entry> entries_;
};

}  // namespace

std::optional<CrossingCells> firstCrossing(const Sheet& sheet, std::span<const Vec3> positions) {
  if (sheet.columns < 2 || sheet.rows < 2) return std::nullopt;
  return Crossings(sheet, positions).first();
}

}  // namespace tyg

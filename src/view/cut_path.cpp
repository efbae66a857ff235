// The line is sampled pixel by pixel: each triangle of the mesh that it crosses offers its depth and its grid
// coordinates to the samples inside, and the nearest wins. What was found is then joined, and straightened where it is
// straight.
#include "view/cut_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tyg {
namespace {

constexpr int kMostSamples = 4096;
constexpr double kJump = 3;        // cells between two samples: beyond, they are on different layers of the cloth
constexpr double kStraight = 0.3;  // cells by which a path may leave its straight line
constexpr double kOutside = 1;     // cell, by which a cut over an edge goes on
constexpr double kBeyond = 0.25;   // cells, by which it goes on elsewhere: what ends there must not hang by a thread
constexpr double kAcross = 0.4;    // cells to both sides of a spring that is cut by itself

/// A particle as seen along the line: pixels along it and across, and what is linear in the window: 1, column and row,
/// each divided by the depth (m).
struct Seen {
  float along = 0, across = 0;
  glm::vec3 share{0};
  [[nodiscard]] bool visible() const { return share.x > 0; }
};

class LineOfSight {
 public:
  LineOfSight(const Camera& camera, glm::vec2 from, glm::vec2 to, glm::vec2 window)
      : view_(camera.view()),
        focal_(window.y / (2 * std::tan(camera.fieldOfView() / 2))),
        shift_(window / 2.0F - from),
        along_(glm::normalize(to - from)),
        nearest_(camera.nearest()) {}

  [[nodiscard]] Seen see(const float* xyz, int column, int row) const {
    const glm::vec4 p = view_ * glm::vec4(xyz[0], xyz[1], xyz[2], 1);
    const glm::vec2 offset = shift_ + focal_ / -p.z * glm::vec2(p.x, -p.y);
    if (!(-p.z > nearest_) || !std::isfinite(offset.x) || !std::isfinite(offset.y)) return {};
    return {glm::dot(offset, along_), along_.x * offset.y - along_.y * offset.x,
            glm::vec3(1, float(column), float(row)) / -p.z};
  }

 private:
  glm::mat4 view_;
  float focal_;
  glm::vec2 shift_, along_;
  float nearest_;
};

/// Where the line crosses an edge between two particles on different sides of it.
Seen crossing(const Seen& a, const Seen& b) {
  const float part = a.across / (a.across - b.across);
  return {glm::mix(a.along, b.along, part), 0, glm::mix(a.share, b.share, part)};
}
bool crosses(const Seen& a, const Seen& b) { return (a.across < 0) != (b.across < 0); }

glm::dvec2 gridOf(const glm::vec3& share) { return glm::dvec2(share.y, share.z) / double(share.x); }

/// What the line sees at each of its samples.
class Samples {
 public:
  explicit Samples(float length)
      : count_(std::clamp(int(std::min(length, float(kMostSamples))), 2, kMostSamples)),
        stride_(length / float(count_ - 1)),
        nearest_(static_cast<std::size_t>(count_), glm::vec3(0)) {}

  void offer(const Seen& a, const Seen& b, const Seen& c) {
    if (!a.visible() || !b.visible() || !c.visible()) return;
    std::array<Seen, 2> ends;
    std::size_t found = 0;
    for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &c), std::pair(&c, &a)}) {
      if (crosses(*one, *other) && found < 2) ends.at(found++) = crossing(*one, *other);
    }
    if (found < 2) return;
    if (ends[0].along > ends[1].along) std::swap(ends[0], ends[1]);
    const float width = ends[1].along - ends[0].along;
    if (!(width > 0)) return;
    const float last = std::min(std::floor(ends[1].along / stride_), float(count_ - 1));
    for (float k = std::max(std::ceil(ends[0].along / stride_), 0.0F); k <= last; ++k) {
      const glm::vec3 share = glm::mix(ends[0].share, ends[1].share, (k * stride_ - ends[0].along) / width);
      glm::vec3& nearest = nearest_[static_cast<std::size_t>(k)];
      if (share.x > nearest.x) nearest = share;
    }
  }

  /// Stretches of cloth: grid coordinates, and whether the line begins or ends on the cloth there.
  struct Stretch {
    std::vector<glm::dvec2> path;
    bool beginsInside = false, endsInside = false;
  };
  [[nodiscard]] std::vector<Stretch> stretches() const {
    std::vector<Stretch> all;
    bool open = false;
    for (std::size_t k = 0; k < nearest_.size(); ++k) {
      if (!(nearest_[k].x > 0)) {
        open = false;
        continue;
      }
      const glm::dvec2 here = gridOf(nearest_[k]);
      if (open) {
        const glm::dvec2 step = glm::abs(here - all.back().path.back());
        open = std::max(step.x, step.y) < kJump;
      }
      if (!open) all.push_back({.path = {}, .beginsInside = k == 0});
      all.back().path.push_back(here);
      all.back().endsInside = k + 1 == nearest_.size();
      open = true;
    }
    return all;
  }

 private:
  int count_;
  float stride_;  // pixels
  std::vector<glm::vec3> nearest_;
};

double distanceFrom(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 way = b - a;
  const double square = glm::dot(way, way);
  const double part = square > 0 ? std::clamp(glm::dot(p - a, way) / square, 0.0, 1.0) : 0;
  return glm::distance(p, a + part * way);
}

/// Douglas and Peucker (1973): keeps the point that is farthest from the straight line, until none is far.
void straighten(std::span<const glm::dvec2> path, std::vector<glm::dvec2>& kept) {
  std::size_t farthest = 0;
  double distance = kStraight;
  for (std::size_t k = 1; k + 1 < path.size(); ++k) {
    if (const double here = distanceFrom(path[k], path.front(), path.back()); here > distance) {
      distance = here, farthest = k;
    }
  }
  if (farthest == 0) return kept.push_back(path.back());
  straighten(path.first(farthest + 1), kept);
  straighten(path.subspan(farthest), kept);
}

/// Moves an end of a path on: outside where it lies at the sheet's edge, else past the end of the cells there.
void extend(glm::dvec2& end, const glm::dvec2& before, const Sheet& sheet) {
  const bool inside =
      end.x > kOutside && end.y > kOutside && end.x < sheet.columns - 1 - kOutside && end.y < sheet.rows - 1 - kOutside;
  const double length = glm::distance(end, before);
  if (length > 0) end += (inside ? kBeyond : kOutside) / length * (end - before);
}

/// What of a sheet is there.
class Grid {
 public:
  explicit Grid(const Sheet& sheet) : sheet_(sheet) {}
  /// The cell whose first corner this is.
  [[nodiscard]] bool hasCell(int column, int row) const {
    return column >= 0 && row >= 0 && column + 1 < sheet_.columns && row + 1 < sheet_.rows &&
           !sheet_.missing.has(row * sheet_.columns + column, Missing::Cell);
  }
  /// Whether the spring to the right of a particle, or below it, is there without a cell beside it.
  [[nodiscard]] bool isBareRight(int column, int row) const {
    return column + 1 < sheet_.columns && !sheet_.missing.has(row * sheet_.columns + column, Missing::Right) &&
           !hasCell(column, row) && !hasCell(column, row - 1);
  }
  [[nodiscard]] bool isBareDown(int column, int row) const {
    return row + 1 < sheet_.rows && !sheet_.missing.has(row * sheet_.columns + column, Missing::Down) &&
           !hasCell(column, row) && !hasCell(column - 1, row);
  }

 private:
  const Sheet& sheet_;
};

/// A short cut across one spring.
void cutSpring(const Seen& a, const Seen& b, float length, std::vector<CutLine>& cuts) {
  if (!a.visible() || !b.visible() || !crosses(a, b)) return;
  const Seen there = crossing(a, b);
  if (there.along < 0 || there.along > length) return;
  const glm::dvec2 at = gridOf(there.share), along = glm::abs(gridOf(b.share) - gridOf(a.share));
  const glm::dvec2 half = along.x > along.y ? glm::dvec2(0, kAcross) : glm::dvec2(kAcross, 0);
  cuts.push_back({at.x - half.x, at.y - half.y, at.x + half.x, at.y + half.y});
}

}  // namespace

std::vector<CutLine> cutsAlong(const Camera& camera, glm::vec2 from, glm::vec2 to, glm::vec2 window, const Sheet& sheet,
                               std::span<const float> xyz) {
  const float length = glm::distance(from, to);
  const auto columns = static_cast<std::size_t>(sheet.columns);
  std::vector<CutLine> cuts;
  if (!(length >= 1) || !(window.y > 0) || xyz.size() < 3 * static_cast<std::size_t>(sheet.count())) return cuts;
  const LineOfSight sight(camera, from, to, window);
  std::vector<Seen> seen;
  for (int row = 0; row < sheet.rows; ++row) {
    for (int column = 0; column < sheet.columns; ++column)
      seen.push_back(sight.see(&xyz[3 * seen.size()], column, row));
  }
  Samples samples(length);
  const Grid grid(sheet);
  for (std::size_t k = 0; k < seen.size(); ++k) {
    const int column = static_cast<int>(k % columns), row = static_cast<int>(k / columns);
    if (grid.isBareRight(column, row)) cutSpring(seen[k], seen[k + 1], length, cuts);
    if (grid.isBareDown(column, row)) cutSpring(seen[k], seen[k + columns], length, cuts);
    if (!grid.hasCell(column, row)) continue;
    samples.offer(seen[k], seen[k + 1], seen[k + columns + 1]);
    samples.offer(seen[k], seen[k + columns + 1], seen[k + columns]);
  }
  for (const Samples::Stretch& stretch : samples.stretches()) {
    std::vector<glm::dvec2> path{stretch.path.front()};
    straighten(stretch.path, path);
    if (!stretch.beginsInside) extend(path[0], path[1], sheet);
    if (!stretch.endsInside) extend(path.back(), path[path.size() - 2], sheet);
    for (std::size_t k = 1; k < path.size(); ++k) {
      const CutLine cut{path[k - 1].x, path[k - 1].y, path[k].x, path[k].y};
      if (path[k - 1] != path[k]) cuts.push_back(cut);
    }
  }
  return cuts;
}

}  // namespace tyg

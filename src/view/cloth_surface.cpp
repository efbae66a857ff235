// The corners of a cell are counted around it: its first particle, then right, below and left. Side i leads from corner
// i to the next. With k >= 1 sides lost, k parts are left, each a run of corners.
#include "view/cloth_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace tyg {
namespace {

constexpr float kLongest = 1.5F;  // spacings: how far an extrapolated neighbour may be
constexpr std::size_t kCorners = 4;

}  // namespace

struct ClothSurface::Cell {
  std::array<int, kCorners> corners{};
  std::array<bool, kCorners> lost{};  ///< sides
  [[nodiscard]] auto losses() const { return std::ranges::count(lost, true); }
};

namespace {

bool hasLostSide(const Sheet& sheet, int particle) {
  const Missing& missing = sheet.missing;
  return missing.has(particle, Missing::Right) || missing.has(particle, Missing::Down) ||
         missing.has(particle + 1, Missing::Down) || missing.has(particle + sheet.columns, Missing::Right);
}

}  // namespace

ClothSurface::ClothSurface(const Sheet& sheet) : sheet_(sheet), normals_(std::size_t(sheet.count())) {
  for (int row = 0; row + 1 < sheet.rows; ++row) {
    for (int column = 0; column + 1 < sheet.columns; ++column) {
      const int first = row * sheet.columns + column;
      if (hasLostSide(sheet, first)) {
        cut_.push_back(first);
        continue;
      }
      const auto a = std::uint32_t(first), b = a + 1, e = a + std::uint32_t(sheet.columns), f = e + 1;
      // Diagonals that take turns show no direction of the grid.
      if ((row + column) % 2 == 0) {
        triangles_.insert(triangles_.end(), {a, b, f, a, f, e});
      } else {
        triangles_.insert(triangles_.end(), {a, b, e, b, f, e});
      }
    }
  }
}

void ClothSurface::follow(std::span<const float> xyz) {
  xyz_ = xyz;
  pieces_.clear();
  std::ranges::fill(normals_, glm::vec3(0));
  addWholeNormals();
  const auto cellAt = [&](int a) {
    const int b = a + 1, e = a + sheet_.columns, f = e + 1;
    return Cell{{a, b, f, e}, {!joined(a, Right), !joined(b, Down), !joined(e, Right), !joined(a, Down)}};
  };
  for (const int first : cut_) addNormals(cellAt(first));
  for (const int first : cut_) addPieces(cellAt(first));
}

glm::vec3 ClothSurface::at(int particle) const {
  const float* p = &xyz_[3 * std::size_t(particle)];
  return {p[0], p[1], p[2]};
}

void ClothSurface::addWholeNormals() {
  const float scale = 1 / float(sheet_.spacing);  // of areas only what they are beside each other counts
  std::size_t nextCut = 0;
  for (int row = 0; row + 1 < sheet_.rows; ++row) {
    const int first = row * sheet_.columns, last = first + sheet_.columns - 1;
    glm::vec3* above = &normals_[std::size_t(first)];
    glm::vec3* below = above + sheet_.columns;
    const float* p = &xyz_[3 * std::size_t(first)];
    const float* q = p + 3 * std::ptrdiff_t(sheet_.columns);
    for (int a = first; a < last; ++a, ++above, ++below, p += 3, q += 3) {
      if (nextCut < cut_.size() && cut_[nextCut] == a) {
        ++nextCut;
        continue;
      }
      const glm::vec3 falling = scale * glm::vec3(q[3] - p[0], q[4] - p[1], q[5] - p[2]);
      const glm::vec3 rising = scale * glm::vec3(q[0] - p[3], q[1] - p[4], q[2] - p[5]);
      const glm::vec3 area = glm::cross(falling, rising);
      above[0] += area, above[1] += area, below[0] += area, below[1] += area;
    }
  }
}

int ClothSurface::neighbour(int particle, Way way) const {
  const std::array<int, 4> steps{1, sheet_.columns, -1, -sheet_.columns};
  return particle + steps.at(way);
}

bool ClothSurface::joined(int particle, Way way) const {
  const int column = particle % sheet_.columns, row = particle / sheet_.columns;
  switch (way) {
    case Right:
      return column + 1 < sheet_.columns && !sheet_.missing.has(particle, Missing::Right);
    case Down:
      return row + 1 < sheet_.rows && !sheet_.missing.has(particle, Missing::Down);
    case Left:
      return column > 0 && !sheet_.missing.has(particle - 1, Missing::Right);
    default:
      return row > 0 && !sheet_.missing.has(particle - sheet_.columns, Missing::Down);
  }
}

/// As the cloth goes on behind the particle, else as it goes beside it, else at a right angle to the spring that it
/// has, else towards where the neighbour is.
glm::vec3 ClothSurface::beyond(int particle, Way way) const {
  const Way back = Way((way + 2) % 4);
  const std::array<Way, 2> asides{Way((way + 1) % 4), Way((way + 3) % 4)};
  const auto step = [this](int from, Way to) { return at(neighbour(from, to)) - at(from); };
  const auto likeBeside = [&]() -> std::optional<glm::vec3> {
    if (joined(particle, back)) return -step(particle, back);
    for (const Way aside : asides) {
      if (!joined(particle, aside)) continue;
      const int beside = neighbour(particle, aside);
      if (joined(beside, way)) return step(beside, way);
      if (joined(beside, back)) return -step(beside, back);
    }
    return std::nullopt;
  };
  const auto withLength = [](const glm::vec3& v, float now, float wanted) { return now > 0 ? wanted / now * v : v; };
  const auto spacing = float(sheet_.spacing);
  if (const auto like = likeBeside()) {
    const float length = glm::length(*like);
    return withLength(*like, length, std::min(length, kLongest * spacing));
  }
  glm::vec3 across = step(particle, way);
  for (const Way aside : asides) {
    if (!joined(particle, aside)) continue;
    const glm::vec3 along = step(particle, aside);
    across -= glm::dot(across, along) / std::max(glm::dot(along, along), 1e-30F) * along;
  }
  return withLength(across, glm::length(across), spacing);
}

ClothVertex ClothSurface::corner(int particle) const {
  const int column = particle % sheet_.columns, row = particle / sheet_.columns;
  return {at(particle), normals_[std::size_t(particle)], {float(column), float(row)}, std::uint32_t(particle)};
}

/// The middle of a side that was lost, as a particle sees it.
ClothVertex ClothSurface::end(int particle, Way way) const {
  const std::array<glm::vec2, 4> halves{{{0.5F, 0}, {0, 0.5F}, {-0.5F, 0}, {0, -0.5F}}};
  ClothVertex vertex = corner(particle);
  vertex.position += 0.5F * beyond(particle, way), vertex.place += halves.at(way);
  return vertex;
}

void ClothSurface::addNormals(const Cell& cell) {
  const float scale = 1 / float(sheet_.spacing);
  for (std::size_t i = 0; i < kCorners; ++i) {
    const int particle = cell.corners[i];
    const auto along = [&](std::size_t side, Way way) {
      return scale * (cell.lost[side] ? beyond(particle, way) : at(neighbour(particle, way)) - at(particle));
    };
    const std::size_t before = (i + 3) % kCorners;
    // Side i leads on from corner i; the side before it leads back.
    normals_[std::size_t(particle)] += 2.0F * glm::cross(along(i, Way(i)), along(before, Way((before + 2) % 4)));
  }
}

void ClothSurface::addPieces(const Cell& cell) {
  const auto losses = cell.losses();
  const auto corner = [&](std::size_t i) { return this->corner(cell.corners[i % kCorners]); };
  const glm::vec2 middle = 0.5F * (corner(0).place + corner(2).place);
  for (std::size_t start = 0; start < kCorners; ++start) {
    const std::size_t before = (start + 3) % kCorners;
    if (!cell.lost[before]) continue;
    std::size_t last = start;
    while (!cell.lost[last % kCorners]) ++last;
    std::array<ClothVertex, 7> ring{};
    std::size_t count = 0;
    const ClothVertex first = end(cell.corners[start], Way((before + 2) % 4));
    const ClothVertex final = end(cell.corners[last % kCorners], Way(last % kCorners));
    ClothVertex centre = corner(start);
    centre.place = middle;
    const bool isSlit = losses == 1, isQuarter = losses > 2 && last == start;
    if (isSlit) {
      centre.position = centre.normal = glm::vec3(0);
      for (std::size_t i = 0; i < kCorners; ++i) {
        centre.position += 0.25F * corner(i).position, centre.normal += 0.25F * corner(i).normal;
      }
    } else if (isQuarter) {
      centre.position = first.position + final.position - centre.position;
    }
    if (isSlit || isQuarter) ring[count++] = centre;
    ring[count++] = first;
    for (std::size_t i = start; i <= last; ++i) ring[count++] = corner(i);
    ring[count++] = final;
    addFan({ring.data(), count}, isSlit || isQuarter ? 0 : count / 2);
  }
}

void ClothSurface::addFan(std::span<const ClothVertex> corners, std::size_t middle) {
  const std::size_t count = corners.size();
  for (std::size_t i = 1; i + 1 < count; ++i) {
    pieces_.insert(pieces_.end(), {corners[middle], corners[(middle + i) % count], corners[(middle + i + 1) % count]});
  }
}

void particleStrains(const Sheet& sheet, std::span<const float> xyz, std::vector<float>& strains) {
  strains.assign(std::size_t(sheet.count()), 0);
  const auto place = [&](std::size_t i) { return glm::vec3(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]); };
  const auto spacing = float(sheet.spacing);
  const auto join = [&](int a, int b) {
    const auto first = std::size_t(a), second = std::size_t(b);
    const float strain = glm::distance(place(first), place(second)) / spacing - 1;
    for (const std::size_t end : {first, second}) {
      if (std::abs(strain) > std::abs(strains[end])) strains[end] = strain;
    }
  };
  for (int particle = 0; particle < sheet.count(); ++particle) {
    const bool isLast = (particle + 1) % sheet.columns == 0, isLowest = particle + sheet.columns >= sheet.count();
    if (!isLast && !sheet.missing.has(particle, Missing::Right)) join(particle, particle + 1);
    if (!isLowest && !sheet.missing.has(particle, Missing::Down)) join(particle, particle + sheet.columns);
  }
}

}  // namespace tyg

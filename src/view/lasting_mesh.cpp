// The middle of a side that is never lost is one point; both ends of one that is lost have a point of their own for it,
// and so has every part of a cell for the middle of the cell.
#include "view/lasting_mesh.h"

#include <algorithm>

namespace tyg {
namespace {

using Way = ClothSurface::Way;

constexpr std::size_t kNext = 1, kOpposite = 2, kBefore = 3;  // corners on from one

/// From corner i of a cell to the corner after it, and to the one before it.
Way onward(std::size_t corner) { return Way(corner); }
Way backward(std::size_t corner) { return Way((corner + kNext) % 4); }

glm::vec2 halfStep(Way way) {
  const std::array<glm::vec2, 4> steps{{{0.5F, 0}, {0, 0.5F}, {-0.5F, 0}, {0, -0.5F}}};
  return steps.at(way);
}

}  // namespace

LastingMesh::LastingMesh(const Sheet& last) : sheet_(last), surface_(last) {
  for (int row = 0; row < last.rows; ++row) {
    for (int column = 0; column < last.columns; ++column) addPoint({float(column), float(row)});
  }
  for (int row = 0; row + 1 < last.rows; ++row) {
    for (int column = 0; column + 1 < last.columns; ++column) addCell(row * last.columns + column);
  }
}

std::uint32_t LastingMesh::addPoint(const glm::vec2& place) {
  places_.push_back(place);
  return std::uint32_t(places_.size() - 1);
}

std::array<int, LastingMesh::kCorners> LastingMesh::cornersOf(int first) const {
  return {first, first + 1, first + sheet_.columns + 1, first + sheet_.columns};
}

/// Side i leads from corner i to the next.
std::array<bool, LastingMesh::kCorners> LastingMesh::lostSides(int first) const {
  const std::array<int, kCorners> corners = cornersOf(first);
  std::array<bool, kCorners> lost{};
  for (std::size_t i = 0; i < kCorners; ++i) lost[i] = !surface_.joined(corners[i], onward(i));
  return lost;
}

void LastingMesh::addCell(int first) {
  const std::array<int, kCorners> corners = cornersOf(first);
  const std::array<bool, kCorners> lost = lostSides(first);
  if (std::ranges::count(lost, true) == 0) {
    auto& quad = quads_.emplace_back();
    std::ranges::copy(corners, quad.begin());
    return;
  }
  const glm::vec2 middle = 0.5F * (places_[std::size_t(corners[0])] + places_[std::size_t(corners[kOpposite])]);
  // Corners on both sides of a lone lost side still hang together.
  const bool isSlit = std::ranges::count(lost, true) == 1;
  const std::size_t begin = std::size_t(std::ranges::find(lost, true) - lost.begin()) + kNext;
  std::uint32_t centre = 0;
  for (std::size_t k = 0; k < kCorners; ++k) {
    const std::size_t i = (begin + k) % kCorners;
    if (k == 0 || (!isSlit && lost[(i + kBefore) % kCorners])) {
      centre = addPoint(middle);
      cellMiddles_.push_back({centre, {first, i}});
    }
    const std::uint32_t on = sideMiddle(corners[i], onward(i)), back = sideMiddle(corners[i], backward(i));
    quads_.push_back({std::uint32_t(corners[i]), on, centre, back});
  }
}

std::uint32_t LastingMesh::sideMiddle(int particle, Way way) {
  if (way > ClothSurface::Down && surface_.joined(particle, way)) {
    particle = surface_.neighbour(particle, way);
    way = Way(way - kOpposite);
  }
  const auto [entry, isNew] = numbers_.try_emplace({particle, way}, 0);
  if (isNew) {
    entry->second = addPoint(places_[std::size_t(particle)] + halfStep(way));
    sideMiddles_.push_back({entry->second, {particle, way}});
  }
  return entry->second;
}

void LastingMesh::follow(const Sheet& now, std::span<const float> xyz) {
  if (!(now.missing == sheet_.missing)) {
    sheet_ = now;
    surface_ = ClothSurface(now);
  }
  surface_.follow(xyz);
  points_.resize(places_.size()), normals_.resize(places_.size());
  const auto unit = [](const glm::vec3& v) { return glm::dot(v, v) > 0 ? glm::normalize(v) : glm::vec3(0); };
  for (std::size_t i = 0; i < surface_.normals().size(); ++i) {
    points_[i] = surface_.at(int(i)), normals_[i] = unit(surface_.normals()[i]);
  }
  for (const auto& [number, middle] : sideMiddles_) {
    points_[number] = positionOf(middle), normals_[number] = normals_[std::size_t(middle.particle)];
  }
  for (const auto& [number, middle] : cellMiddles_) {
    points_[number] = positionOf(middle);
    normals_[number] = normals_[std::size_t(cornersOf(middle.first)[middle.corner])];
  }
}

glm::vec3 LastingMesh::positionOf(const SideMiddle& middle) const {
  const glm::vec3 here = surface_.at(middle.particle);
  if (!surface_.joined(middle.particle, middle.way)) return here + 0.5F * surface_.beyond(middle.particle, middle.way);
  return 0.5F * (here + surface_.at(surface_.neighbour(middle.particle, middle.way)));
}

/// From the corners of the cell that still hang together with this one.
glm::vec3 LastingMesh::positionOf(const CellMiddle& middle) const {
  const std::array<int, kCorners> corners = cornersOf(middle.first);
  const std::array<bool, kCorners> lost = lostSides(middle.first);
  const auto at = [&](std::size_t i) { return surface_.at(corners[i % kCorners]); };
  if (std::ranges::count(lost, true) < 2) return 0.25F * (at(0) + at(1) + at(2) + at(3));
  std::size_t first = middle.corner, last = middle.corner;
  while (!lost[(first + kBefore) % kCorners]) first = (first + kBefore) % kCorners;
  while (!lost[last]) last = (last + kNext) % kCorners;
  const glm::vec3 begin = positionOf(SideMiddle{corners[first], backward(first)});
  const glm::vec3 end = positionOf(SideMiddle{corners[last], onward(last)});
  if (first == last) return begin + end - at(first);
  const bool isThree = (first + kOpposite) % kCorners == last;
  return isThree ? 0.5F * (at(first) + at(last)) : 0.5F * (begin + end);
}

}  // namespace tyg

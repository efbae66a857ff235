// Neighbours are those that structural springs join a particle to, on both sides along a row or a column, so that at an
// edge the shape of the cloth itself is no distance.
#include "view/against_neighbours.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace tyg {
namespace {

class Neighbourhood {
 public:
  Neighbourhood(const Sheet& sheet, std::span<const float> xyz) : sheet_(sheet), xyz_(xyz) {}

  /// From the middle of its neighbours to a particle, m.
  [[nodiscard]] glm::vec3 away(int particle) const {
    const int column = particle % sheet_.columns, row = particle / sheet_.columns, down = sheet_.columns;
    glm::vec3 sum(0);
    int pairs = 0;
    if (column > 0 && column + 1 < sheet_.columns) sum += at(particle - 1) + at(particle + 1), ++pairs;
    if (row > 0 && row + 1 < sheet_.rows) sum += at(particle - down) + at(particle + down), ++pairs;
    return pairs > 0 ? at(particle) - sum / float(2 * pairs) : glm::vec3(0);
  }

 private:
  [[nodiscard]] glm::vec3 at(int particle) const {
    const float* p = &xyz_[3 * static_cast<std::size_t>(particle)];
    return {p[0], p[1], p[2]};
  }
  const Sheet& sheet_;
  std::span<const float> xyz_;
};

}  // namespace

void againstNeighbours(const Sheet& sheet, std::span<const float> xyz, std::span<float> values) {
  const Neighbourhood neighbourhood(sheet, xyz);
  glm::vec3 farthest(0);
  float most = 0;
  for (int particle = 0; particle < sheet.count(); ++particle) {
    const glm::vec3 away = neighbourhood.away(particle);
    if (glm::length(away) > most && std::isfinite(glm::length(away))) farthest = away, most = glm::length(away);
  }
  std::ranges::fill(values, 0.0F);
  if (!(most > 0)) return;
  const glm::vec3 direction = farthest / most;
  for (int particle = 0; particle < sheet.count(); ++particle) {
    const float share = glm::dot(neighbourhood.away(particle), direction) / most;
    values[static_cast<std::size_t>(particle)] = std::isfinite(share) ? std::clamp(share, -1.0F, 1.0F) : 0;
  }
}

}  // namespace tyg

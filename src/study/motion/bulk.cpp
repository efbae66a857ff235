// Means over all particles are means over the mass, because all particles have the same mass.
#include "study/motion/bulk.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tyg {

std::vector<Bulk> bulkOf(const SampledMotion& motion) {
  std::vector<Bulk> all;
  for (std::size_t k = 0; k < motion.positions.size(); ++k) {
    const std::vector<Vec3>& at = motion.positions[k];
    const auto count = static_cast<double>(at.size());
    Bulk bulk;
    bulk.energy = motion.energies[k];
    for (const Vec3& x : at) bulk.centre = {bulk.centre.x + x.x, bulk.centre.y + x.y, bulk.centre.z + x.z};
    bulk.centre = {bulk.centre.x / count, bulk.centre.y / count, bulk.centre.z / count};
    double sum = 0;
    for (const Vec3& x : at) {
      const double apart = std::hypot(x.x - bulk.centre.x, x.y - bulk.centre.y, x.z - bulk.centre.z);
      sum += apart * apart;
    }
    bulk.gyration = std::sqrt(sum / count);
    all.push_back(bulk);
  }
  return all;
}

BulkDistance bulkDistance(std::span<const Bulk> a, std::span<const Bulk> b, std::size_t first) {
  if (a.size() != b.size()) {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    return {kUnknown, kUnknown, kUnknown};
  }
  BulkDistance largest;
  for (std::size_t k = first; k < a.size(); ++k) {
    const Vec3 &x = a[k].centre, &y = b[k].centre;
    largest.centre = std::max(largest.centre, std::hypot(x.x - y.x, x.y - y.y, x.z - y.z));
    largest.gyration = std::max(largest.gyration, std::abs(a[k].gyration - b[k].gyration));
    largest.energy = std::max(largest.energy, std::abs(a[k].energy - b[k].energy));
  }
  return largest;
}

}  // namespace tyg

// Each label in turn takes the best of some positions around its point: overlaps cost most, then crossed lines, then
// distance.
#include "study/charts/label_places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tyg {
namespace {

constexpr double kGap = 26;  // pixels between a point and its label
constexpr double kOverlapCost = 1e5, kOutsideCost = 1e6, kLineCost = 120, kOrderCost = 100, kLeaderCost = 400;

PixelBox boxAt(double left, double centre, const WantedLabel& label) {
  return {left, left + label.width, centre - label.height / 2, centre + label.height / 2};
}

/// Right and left of the point at several heights, then above and below it.
std::vector<PixelBox> candidates(const WantedLabel& label) {
  std::vector<PixelBox> boxes;
  for (int k = 0; k <= 24; ++k) {
    const int halves = k % 2 == 0 ? k / 2 : -(k + 1) / 2;
    const double shift = 0.5 * halves * label.height;
    for (const double away : {kGap, 2.5 * kGap, 5 * kGap, 8 * kGap, 12 * kGap}) {
      boxes.push_back(boxAt(label.at.x + away, label.at.y + shift, label));
      boxes.push_back(boxAt(label.at.x - away - label.width, label.at.y + shift, label));
    }
    if (std::abs(shift) > label.height) boxes.push_back(boxAt(label.at.x - label.width / 2, label.at.y + shift, label));
  }
  return boxes;
}

/// From the point to the nearest point of the box; boxes to the left count as further away, because curves come from
/// there.
double distanceCost(const Pixel& at, const PixelBox& box) {
  const double x = std::clamp(at.x, box.left, box.right) - at.x, y = (box.top + box.bottom) / 2 - at.y;
  return std::hypot(x, y) + (box.left < at.x ? 40 : 0);
}

}  // namespace

bool PixelBox::meets(const PixelBox& other) const {
  return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
}

bool PixelBox::meetsLine(const Pixel& a, const Pixel& b) const {
  // Clipping (Liang and Barsky 1984): the part of the line between two opposite edges, for both pairs of edges.
  double from = 0, to = 1;
  const auto clip = [&](double start, double along, double low, double high) {
    if (along == 0) {
      if (start < low || start > high) to = -1;
      return;
    }
    const double t0 = (low - start) / along, t1 = (high - start) / along;
    from = std::max(from, std::min(t0, t1));
    to = std::min(to, std::max(t0, t1));
  };
  clip(a.x, b.x - a.x, left, right);
  clip(a.y, b.y - a.y, top, bottom);
  return from <= to;
}

std::optional<Pixel> leaderTo(const PixelBox& box, const Pixel& at) {
  constexpr double kAside = 6, kNear = 45;  // pixels
  const double centre = (box.top + box.bottom) / 2, near = std::clamp(at.x, box.left - kAside, box.right + kAside);
  if (std::hypot(near - at.x, centre - at.y) <= kNear) return std::nullopt;
  return Pixel{near, near != at.x ? centre : centre < at.y ? box.bottom : box.top};
}

std::vector<PixelBox> placeLabels(const std::vector<WantedLabel>& wanted, const std::vector<std::vector<Pixel>>& lines,
                                  const std::vector<PixelBox>& taken, const PixelBox& bounds) {
  std::vector<PixelBox> placed, inTheWay = taken;
  std::vector<std::pair<Pixel, Pixel>> leaders;  // of those that are placed
  const auto leadersCrossed = [&](const PixelBox& box, const Pixel& at) {
    const auto crosses = [](const PixelBox& label, const Pixel& from, const Pixel& to) {
      return label.meetsLine(from, to) ? 1 : 0;
    };
    int count = 0;
    for (const auto& [from, to] : leaders) count += crosses(box, from, to);
    if (const auto tip = leaderTo(box, at)) {
      for (const PixelBox& other : placed) count += crosses(other, at, *tip);
    }
    return count;
  };
  /// Labels one above the other are to be in the order of their points.
  const auto outOfOrder = [&](const PixelBox& box, const Pixel& at) {
    int count = 0;
    for (std::size_t k = 0; k < placed.size(); ++k) {
      const bool beside = box.left < placed[k].right && placed[k].left < box.right;
      if (beside && (at.y - wanted[k].at.y) * (box.top - placed[k].top) < 0) ++count;
    }
    return count;
  };
  const auto cost = [&](const PixelBox& box, const Pixel& at) {
    double sum = distanceCost(at, box) + kOrderCost * outOfOrder(box, at) + kLeaderCost * leadersCrossed(box, at);
    if (box.left < bounds.left || box.right > bounds.right || box.top < bounds.top || box.bottom > bounds.bottom) {
      sum += kOutsideCost;
    }
    for (const PixelBox& other : inTheWay) sum += box.meets(other) ? kOverlapCost : 0;
    for (const std::vector<Pixel>& line : lines) {
      for (std::size_t k = 0; k < line.size(); ++k) {
        sum += box.meetsLine(line[k], line[k + 1 < line.size() ? k + 1 : k]) ? kLineCost : 0;
      }
    }
    return sum;
  };
  for (const WantedLabel& label : wanted) {
    PixelBox best;
    double least = std::numeric_limits<double>::infinity();
    for (const PixelBox& box : candidates(label)) {
      const double here = cost(box, label.at);
      if (here < least) least = here, best = box;
    }
    placed.push_back(best);
    inTheWay.push_back(best);
    if (const auto tip = leaderTo(best, label.at)) leaders.emplace_back(label.at, *tip);
  }
  return placed;
}

}  // namespace tyg

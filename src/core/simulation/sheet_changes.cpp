// Pins and held particles are sorted lists; both are pins to everything that moves the sheet.
#include "core/simulation/sheet_changes.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace tyg {
namespace {

bool has(const std::vector<int>& sorted, int particle) { return std::ranges::binary_search(sorted, particle); }

/// Returns whether that changed the list.
bool put(std::vector<int>& sorted, int particle, bool wanted) {
  if (has(sorted, particle) == wanted) return false;
  const auto place = std::ranges::lower_bound(sorted, particle);
  wanted ? void(sorted.insert(place, particle)) : void(sorted.erase(place));
  return true;
}

}  // namespace

SheetChanges::SheetChanges(const Scene& scene, const Sheet& sheet)
    : sheet_(sheet), pins_(sheet.pins), toCome_(scene.cuts.size()) {
  std::iota(toCome_.begin(), toCome_.end(), std::size_t{0});
  std::ranges::stable_sort(toCome_, {}, [&](std::size_t k) { return scene.cuts[k].at; });
  std::ranges::reverse(toCome_);
}

void SheetChanges::gatherPins() {
  sheet_.pins.clear();
  std::ranges::set_union(pins_, held_, std::back_inserter(sheet_.pins));
}

void SheetChanges::pin(int particle, bool pinned) {
  if (put(pins_, particle, pinned)) gatherPins();
}

bool SheetChanges::hold(int particle) {
  if (!put(held_, particle, true)) return false;
  gatherPins();
  return true;
}

bool SheetChanges::release(int particle) {
  if (!put(held_, particle, false)) return false;
  gatherPins();
  return true;
}

bool SheetChanges::holds(int particle) const { return has(held_, particle); }

void SheetChanges::cut(const CutLine& line) {
  beforeCuts_.push_back(sheet_.missing);
  sheet_.missing = sheet_.missing.withCut(sheet_.columns, sheet_.rows, line);
}

void SheetChanges::mend(int cuts) {
  for (; cuts > 0 && !beforeCuts_.empty(); --cuts) {
    sheet_.missing = std::move(beforeCuts_.back());
    beforeCuts_.pop_back();
  }
}

void SheetChanges::tear(std::span<const SpringEnds> tooLong) {
  for (const SpringEnds& ends : tooLong) {
    const bool isAcross = sheet_.columns > 1 && ends.second == ends.first + 1;
    if (sheet_.missing.has(ends.first, isAcross ? Missing::Right : Missing::Down)) continue;
    const double column = ends.first % sheet_.columns, row = int(ends.first / sheet_.columns);
    const CutLine dual = isAcross ? CutLine{column + 0.5, row - 0.5, column + 0.5, row + 0.5}
                                  : CutLine{column - 0.5, row + 0.5, column + 0.5, row + 0.5};
    cutForGood(dual);
  }
}

void SheetChanges::cutForGood(const CutLine& line) {
  sheet_.missing = sheet_.missing.withCut(sheet_.columns, sheet_.rows, line);
  for (Missing& before : beforeCuts_) before = before.withCut(sheet_.columns, sheet_.rows, line);
}

void SheetChanges::cutOfScene(const Scene& scene, const Instant& now) {
  for (; !toCome_.empty() && scene.cuts[toCome_.back()].at <= now.time + now.sameTime; toCome_.pop_back()) {
    cutForGood(scene.cuts[toCome_.back()].line);
  }
}

}  // namespace tyg

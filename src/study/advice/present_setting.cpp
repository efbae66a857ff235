// Between two rows, errors and costs lie on a straight line on logarithmic scales; beyond the rows the method's order
// gives the slope of that line.
#include "study/advice/present_setting.h"

#include <algorithm>
#include <cmath>

namespace tyg {
namespace {

using Kind = SettingEstimate::Kind;

bool hasHeld(const WorkRow& row) { return row.status == RowStatus::Ok && row.rmsError > 0 && row.seconds > 0; }
bool hasFailed(const WorkRow& row) { return row.status == RowStatus::Unstable || row.status == RowStatus::NotFinite; }

/// Step or tolerance: what a ladder goes down by.
double rungOf(const WorkRow& row, const Method& method) { return method.adaptive ? row.tolerance : row.dt; }

/// The y at x on the straight line through two points, all in logarithms.
double between(double x, double x0, double x1, double y0, double y1) {
  const double share = std::log(x / x0) / std::log(x1 / x0);
  return y0 * std::pow(y1 / y0, share);
}

/// Extrapolates from a row by the method's order. Every fixed step costs the same; the steps of an adaptive method are
/// taken to follow the (order + 1)-th root of its tolerance. That is a guess: measured exponents are 1/5.9 (dopri54)
/// and 1/4 to 1/3 (bs32), which is why a search only takes 1/order as their upper bound.
SettingEstimate extrapolated(const WorkRow& row, const Method& method, double rung, Kind kind) {
  const double ratio = rung / rungOf(row, method);
  const double errorPower = method.adaptive ? 1 : method.order;
  const double costPower = method.adaptive ? 1.0 / (method.order + 1) : 1;
  return {.kind = kind,
          .error = std::max(row.floor, row.rmsError * std::pow(ratio, errorPower)),
          .seconds = row.seconds * std::pow(ratio, -costPower)};
}

}  // namespace

SettingEstimate estimateOf(const std::vector<WorkRow>& rows, const Setting& setting) {
  const Method& method = *setting.method;
  const double rung = method.adaptive ? setting.tolerance : setting.dt;
  constexpr double kSame = 1 + 1e-9;
  const WorkRow *finer = nullptr,
                *coarser = nullptr;  // the nearest on each side, a row at the very setting counts as both
  for (const WorkRow& row : rows) {
    if (row.integrator != method.name || !(hasHeld(row) || hasFailed(row))) continue;
    const double here = rungOf(row, method);
    if (here <= rung * kSame && (finer == nullptr || here > rungOf(*finer, method))) finer = &row;
    if (here * kSame >= rung && (coarser == nullptr || here < rungOf(*coarser, method))) coarser = &row;
  }
  const bool past = !method.adaptive && setting.dt > setting.limit;
  if (past || (finer != nullptr && hasFailed(*finer))) {
    return {.kind = Kind::Fails, .error = WorkRow::kNone, .seconds = WorkRow::kNone};
  }
  if (finer == nullptr) {
    if (coarser == nullptr || hasFailed(*coarser)) return {};
    return extrapolated(*coarser, method, rung, Kind::Finer);
  }
  if (coarser == nullptr || hasFailed(*coarser)) {
    if (rungOf(*finer, method) * kSame >= rung) return {Kind::Measured, finer->rmsError, finer->seconds};
    return extrapolated(*finer, method, rung, Kind::Coarser);
  }
  if (finer == coarser) return {Kind::Measured, finer->rmsError, finer->seconds};
  const double x0 = rungOf(*finer, method), x1 = rungOf(*coarser, method);
  return {Kind::Between, between(rung, x0, x1, finer->rmsError, coarser->rmsError),
          between(rung, x0, x1, finer->seconds, coarser->seconds)};
}

std::vector<const WorkRow*> frontierOf(const std::vector<WorkRow>& rows) {
  std::vector<const WorkRow*> order, frontier;
  for (const WorkRow& row : rows) {
    if (hasHeld(row)) order.push_back(&row);
  }
  std::ranges::stable_sort(order, {}, &WorkRow::seconds);
  for (const WorkRow* row : order) {
    if (frontier.empty() || row->rmsError < frontier.back()->rmsError) frontier.push_back(row);
  }
  return frontier;
}

BetterRows betterThan(const std::vector<WorkRow>& rows, const SettingEstimate& estimate) {
  constexpr double kClearlyCheaper = 0.9, kClearlyCloser = 0.5;
  BetterRows better;
  if (!(estimate.error > 0)) return better;
  for (const WorkRow& row : rows) {
    if (!hasHeld(row)) continue;
    if (row.rmsError <= estimate.error && row.seconds <= kClearlyCheaper * estimate.seconds &&
        (better.cheaper == nullptr || row.seconds < better.cheaper->seconds)) {
      better.cheaper = &row;
    }
    if (row.seconds <= estimate.seconds && row.rmsError <= kClearlyCloser * estimate.error &&
        (better.closer == nullptr || row.rmsError < better.closer->rmsError)) {
      better.closer = &row;
    }
  }
  return better;
}

}  // namespace tyg

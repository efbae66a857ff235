// One pass over the rows keeps the cheapest of each method and precision that is within the error.
#include "study/work/frontier.h"

#include <algorithm>

namespace tyg {

std::vector<Price> pricesOf(const std::vector<WorkRow>& rows, double error, Cost cost) {
  std::vector<Price> prices;
  for (const WorkRow& row : rows) {
    const Price price{row.integrator, row.precision,
                      cost == Cost::Seconds ? row.seconds : static_cast<double>(row.forceEvaluations), row.dt,
                      row.tolerance};
    if (row.status != RowStatus::Ok || !(row.rmsError + row.floor <= error) || !(price.cost > 0)) continue;
    const auto same = std::ranges::find_if(prices, [&](const Price& other) {
      return other.integrator == row.integrator && other.precision == row.precision;
    });
    if (same == prices.end()) {
      prices.push_back(price);
    } else if (price.cost < same->cost) {
      *same = price;
    }
  }
  std::ranges::stable_sort(prices, {}, &Price::cost);
  return prices;
}

}  // namespace tyg

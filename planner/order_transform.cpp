#include "planner/order_transform.h"

#include <algorithm>
#include <array>

namespace headland {

void transform(OrderSearch& search, Individual& one, int k, const TransformShares& shares) {
  const double drawn = draw_unit(search.random) * (shares.swap + shares.shift + shares.symmetry);
  const int other = draw_place(search);
  if (drawn < shares.swap) {
    try_swap(search, one, k, other, Keep::kNotWorse);
  } else if (drawn < shares.swap + shares.shift) {
    try_shift(search, one, k, other, Keep::kNotWorse);
  } else {
    try_reversal(search, one, std::min(k, other), std::max(k, other), Keep::kNotWorse);
  }
}

std::span<const ParameterSpec> transforming_parameters() {
  static const std::array kSpecs{
      population_spec(),
      ParameterSpec{"st1", 0.5, 0.0, 1.0, {}, "first search tendency"},
      ParameterSpec{"st2", 0.5, 0.0, 1.0, {}, "second search tendency"},
      ParameterSpec{"swap", 0.2, 0.0, 1.0, {}, "share of swaps"},
      ParameterSpec{"shift", 0.5, 0.0, 1.0, {}, "share of shifts"},
      ParameterSpec{"symmetry", 0.3, 0.0, 1.0, {}, "share of reversals; of all when all are 0"}};
  return kSpecs;
}

TransformingSearch transforming_search(const Parameters& parameters) {
  return {
      number(parameters, "st1"),
      number(parameters, "st2"),
      {number(parameters, "swap"), number(parameters, "shift"), number(parameters, "symmetry")}};
}

}  // namespace headland

// Transformations of orders that DJAYA and DTSA choose among.
#pragma once

#include <span>

#include "planner/order_population.h"

namespace headland {

// Shares of the three, which need not sum to 1; of symmetry alone when all are 0.
struct TransformShares {
  double swap = 0.2;
  double shift = 0.5;
  double symmetry = 0.3;
};

// Tries one at place k with a place drawn: swap and shift as try_swap and try_shift, symmetry as
// try_reversal of what lies between. Changes that make the order costlier are not kept.
void transform(OrderSearch& search, Individual& one, int k, const TransformShares& shares);

// What both planners are told: `population`, `st1`, `st2` and the shares, by default those of Wang
// et al. 2025 (10.20944/preprints202504.0101.v1), Table 1.
std::span<const ParameterSpec> transforming_parameters();

struct TransformingSearch {
  double st1 = 0.5;  // first and second search tendency
  double st2 = 0.5;
  TransformShares shares;
};
TransformingSearch transforming_search(const Parameters& parameters);

}  // namespace headland

// Orders to begin a search with.
#pragma once

#include <vector>

#include "planner/grid_plan.h"

namespace headland {

// Wang et al. 2025 (10.20944/preprints202504.0101.v1), 4.1: with probability `greediness` an order
// that goes from cell to cell, else random_order. Each next one is with probability `greediness` a
// nearest of those not yet visited (Eq 9), else drawn by 1 / d^lambda (Eq 8). That is the
// paper's rule (rand < alpha_g); its remark that a low alpha_g is greedier contradicts it. Ties of
// Eq (9) are broken at random: by first index all orders would be one. A given end comes last.
std::vector<int> greedy_order(const GridProblem& problem, const DistanceTable& table,
                              double greediness, double lambda, SeededRandom& random);

}  // namespace headland

// Discrete tree-seed algorithm on orders of cells.
#pragma once

#include <span>

#include "planner/grid_plan.h"

namespace headland {

std::span<const ParameterSpec> grid_dtsa_parameters();

// Cinar, Korkmaz, Kiran, 'A discrete tree-seed algorithm for solving symmetric traveling salesman
// problem', 2020, with the parameters of Wang et al. 2025 (10.20944/preprints202504.0101.v1), Table
// 1: st1 = st2 = 0.5, transformations swap, shift and symmetry by 0.2, 0.5, 0.3.
// Reading: at each place k in turn a seed comes with probability st1 from the best tree, else from
// any tree, by learning (order_population.h); then, with probability st2, from the tree itself by a
// transformation (order_transform.h). A seed that is not costlier replaces its tree at once. Orders
// begin as greedy_order(), as those of CCPP-TPLP, so that the two differ in who learns from whom
// and not in the budget.
// Throws InputError as grid_problem and distance_table; Cancelled.
GridPlan plan_grid_dtsa(const GridPlanRequest& request);

}  // namespace headland

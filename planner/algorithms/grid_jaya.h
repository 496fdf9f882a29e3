// Discrete Jaya on orders of cells.
#pragma once

#include <span>

#include "planner/grid_plan.h"

namespace headland {

std::span<const ParameterSpec> grid_djaya_parameters();

// Gunduz and Aslan, 'DJAYA: a discrete Jaya algorithm for solving traveling salesman problem',
// 2021, with the parameters of Wang et al. 2025 (10.20944/preprints202504.0101.v1), Table 1: st1 =
// st2 = 0.5, transformations swap, shift and symmetry by 0.2, 0.5, 0.3. Reading: going to the best,
// at each place k in turn and with probability st1, is learning from it (order_population.h); going
// away from the worst is a transformation (order_transform.h), tried with probability st2 and
// wherever the pair at the place is one of the worst's too. Orders begin as greedy_order(), and
// changes that make them costlier are not kept: both of CCPP-TPLP, so that the two differ in who
// learns from whom and not in the budget. Throws InputError as grid_problem and distance_table;
// Cancelled.
GridPlan plan_grid_djaya(const GridPlanRequest& request);

}  // namespace headland

// Grey wolf optimizer on orders of cells.
#pragma once

#include <span>

#include "planner/grid_plan.h"

namespace headland {

std::span<const ParameterSpec> grid_gwo_parameters();

// Mirjalili, Mirjalili, Lewis, 'Grey wolf optimizer', 2014, with the parameters of Wang et al. 2025
// (10.20944/preprints202504.0101.v1), Table 1: the convergence factor a falls linearly from 2 to 0
// over the search (share_over). GWO moves points in space by X = X_leader - A D, A = 2 a r1 - a
// (its Eqs 3.3 to 3.7); neither paper says what that is for orders. Reading: at each place k in
// turn A is drawn. |A| < 1 attacks: learns (order_population.h) from one of the three best, each as
// likely, where GWO takes their mean, which orders do not have; else searches: is perturbed weakly.
// C, which weighs the prey's position, has no counterpart. Orders begin as greedy_order(), and
// changes that make them costlier are not kept: both of CCPP-TPLP, so that the two differ in who
// learns from whom and not in the budget. Throws InputError as grid_problem and distance_table;
// Cancelled.
GridPlan plan_grid_gwo(const GridPlanRequest& request);

}  // namespace headland

// Student psychology based optimization on orders of cells.
#pragma once

#include <span>

#include "planner/order_population.h"

namespace headland {

std::span<const ParameterSpec> grid_spbo_parameters();

// Das, Mukherjee, Das, 'Student psychology based optimization algorithm', 2020, with the groups of
// Wang et al. 2025 (10.20944/preprints202504.0101.v1), Table 1: 1:1:1:1. SPBO adds differences of
// points; neither paper says what that is for orders.
// Reading: sorted into four groups as equal as can be, at each place k in turn the best students
// learn (order_population.h) from any, good ones from the best, average ones from any that is
// better, the others, who study at random, are perturbed weakly. Orders begin as greedy_order(),
// and changes that make them costlier are not kept: both of CCPP-TPLP, so that the two differ in
// who learns from whom and not in the budget.
// Throws InputError as grid_problem and distance_table; Cancelled.
GridPlan plan_grid_spbo(const GridPlanRequest& request);

// The same for evolve() on a population of any origin.
Improve student_psychology();

}  // namespace headland

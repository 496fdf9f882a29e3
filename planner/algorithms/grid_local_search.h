// Iterated local search over the order of cells: our own.
#pragma once

#include <span>

#include "planner/grid_plan.h"

namespace headland {

std::span<const ParameterSpec> grid_local_search_parameters();

// One order, begun greedily (nearest_cell_order) and improved until no small change makes it
// cheaper (order_descent.h). Then it is kicked - two neighbouring sections of up to `kick_cells`
// change places - improved around the kick, and taken back unless it is at most as costly as
// before: equal ones are kept, which lets it wander. An iteration is as many kicks as there are
// cells. After `patience` iterations without gain it begins anew with another greedy order; the
// best of all is the plan. Ends early when the path is as short as least_steps.
// On maps of more than kMaxTableNodes cells it begins with boustrophedon's order and knows the
// distances of near cells only (local_distances): plans are counted exactly in the end, costs on
// the way are not known, and the result is never costlier than boustrophedon.
// Method: Lourenco, Martin, Stuetzle, 'Iterated local search', 2003.
// Throws InputError as grid_problem; Cancelled.
GridPlan plan_grid_local_search(const GridPlanRequest& request);

}  // namespace headland

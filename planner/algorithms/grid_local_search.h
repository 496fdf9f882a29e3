// Iterated local search over the order of cells: our own.
#pragma once

#include <span>

#include "planner/grid_plan.h"

namespace headland {

std::span<const ParameterSpec> grid_local_search_parameters();

// One order, begun greedily (greedy_order) and improved until no move of these makes it cheaper:
// turning a section round (2-opt) and moving up to three cells elsewhere, turned round or not
// (Or-opt), where either brings a cell beside one of its near ones. Then it is kicked - two
// neighbouring sections of up to `kick_cells` change places (a double bridge) - improved around the
// kick, and taken back unless it is at most as costly as before: equal ones are kept, which lets it
// wander. An iteration is as many kicks as there are cells. Cells that are reached and left by
// single steps straight on are not looked at; where length alone counts near cells are those within
// three steps and nearer than the present neighbours, else neighbours on the map. Ends early when
// the path is as short as least_steps.
// Method: Lourenco, Martin, Stuetzle, 'Iterated local search', 2003; Bentley, 'Fast algorithms for
// geometric traveling salesman problems', 1992.
// Throws InputError as grid_problem and distance_table; Cancelled.
GridPlan plan_grid_local_search(const GridPlanRequest& request);

}  // namespace headland

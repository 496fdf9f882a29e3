// Row by row, fetching what is left behind obstacles.
#pragma once

#include "planner/grid_plan.h"

namespace headland {

// The boustrophedon that Wu et al. 2023 (10.20944/preprints202305.1306.v1) compare with, as their
// 3.4 and Figure 18 tell it: "moves a grid up to cross the obstacle, then returns to the previous
// working path". What they leave open is fixed so that their Table 1 comes out to the digit on
// examples/maps/field_A to field_D:
// 1. Begin at the leftmost free cell of the lowest row and head right.
// 2. For each column ahead: if its cell of the row is not yet covered, go there by a shortest way
//    (ties: up, left, right, down); if then the cell below was left behind, fetch it.
// 3. At the row's end step up, or go back along the row to the nearest column that is open above;
//    turn round.
// 4. After the last row go to the nearest cell that is not covered, until there is none.
// A start elsewhere is joined by a shortest way to where rows begin, an end likewise after all.
// Nothing is random or searched: one plan, whatever the cost. Any size of map, near linear time.
// Throws InputError as grid_problem; Cancelled.
GridPlan plan_grid_boustrophedon(const GridPlanRequest& request);

}  // namespace headland

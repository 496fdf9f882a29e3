// Up and down in the best direction, cell by cell, with rounds along the boundary.
#pragma once

#include <span>

#include "planner/plan.h"

namespace headland {

std::span<const ParameterSpec> boustrophedon_parameters();

// 1. Headland: `headland_passes` rounds of the working width inside the boundary and around holes
//    and obstacles (make_headland); auto takes as many as turning needs (rounds_for_turning).
// 2. Swaths over the rest in `swath_direction_deg`, or in the best direction (best_swaths).
// 3. Swaths cut by holes are grouped into cells, each driven up and down, in a short order
//    (order_cells).
// 4. Rounds are driven before the swaths, from the outermost inwards, or after them, from the
//    innermost outwards, `headland_order` says which; each begins at its point, and runs in the
//    direction, with the shortest Dubins curve from where the vehicle comes from.
// Flat: the terrain is not looked at. Nothing is random: the seed is not used. Corners of the
// field that a round cannot reach into with the turning radius stay unworked.
// Boundary and holes are taken as simplified() gives them.
// Throws InputError for a working width or radius that is not a positive number, an implement or
// vehicle wider than the field; PlanInfeasible when no round fits, swaths would be too many
// or the outline is all teeth;
// Cancelled.
Plan plan_boustrophedon(const PlanRequest& request);

}  // namespace headland

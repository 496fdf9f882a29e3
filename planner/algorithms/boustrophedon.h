// Up and down in the best direction, cell by cell, with rounds along the boundary.
#pragma once

#include <span>
#include <string>

#include "planner/plan.h"

namespace headland {

std::span<const ParameterSpec> boustrophedon_parameters();

// As check_swath_parameters, and for `overhang_m` without `headland_corners` covered.
void check_boustrophedon(const Parameters& parameters, const std::string& source,
                         const std::string& where);

// 1. Headland: `headland_passes` rounds of the working width inside the boundary and around holes
//    and obstacles (make_headland); auto takes as many as turning needs (rounds_for_turning).
// 2. Swaths over the rest in their direction (chosen_swaths).
// 3. They are ordered by `swath_order` (ordered_swaths).
// 4. Rounds are driven before the swaths, from the outermost inwards, or after them, from the
//    innermost outwards, `headland_order` says which; each begins at its point, and runs in the
//    direction, with the shortest Dubins curve from where the vehicle comes from.
// 5. With `headland_corners` rounded, corners of the field that a round cannot reach into with the
//    turning radius stay unworked. Covered, rounds are passes into the corners (edge_round), and
//    what they and the swaths leave is worked by passes of its own (fill_passes), both `optional`;
//    they are driven last, or first with rounds that are.
// Nothing is random: the seed is not used. The terrain tells with `swath_objective` energy alone.
// Boundary and holes are taken as simplified() gives them.
// Throws InputError as check_boustrophedon, for covered corners of who drives forward only, for a
// working width or radius that is not a positive number, an implement or
// vehicle wider than the field; PlanInfeasible when no round fits, swaths would be too many
// or the outline is all teeth;
// Cancelled.
Plan plan_boustrophedon(const PlanRequest& request);

}  // namespace headland

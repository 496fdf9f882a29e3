// Fields cut into parts, each worked up and down in its own direction.
#pragma once

#include <span>

#include "planner/plan.h"

namespace headland {

std::span<const ParameterSpec> decomposed_parameters();

// 1. Headland as in plan_boustrophedon, with rounds past the corners.
// 2. The ground inside it is cut into parts (region_parts with `decomposition`), where its outline
//    with bends of less than half a working width left out has its corners. Parts of less than
//    kLeastPart working widths squared go to neighbours, and neighbours that one direction serves
//    with no more lines are one part.
// 3. Each part has swaths in the direction that is best for it by `swath_objective`
//    (swath_objective.h). Where all parts together cost no less than swaths in one direction over
//    the whole, there is one part.
// 4. Parts, and pieces of a part between holes (cells_of), are visited in a short order, each from
//    the one of its four corners that suits it: proven shortest where dynamic programming can
//    (plan_region_exact), else by plan_region_local_search with the request's seed; between them
//    ways count as the crow flies. Within a piece swaths follow each other by `swath_order`. With
//    measured costs all of this counts in W h, and `swath_order` auto improves the whole order of
//    swaths by them (optimised_order).
// Throws as plan_boustrophedon.
Plan plan_decomposed(const PlanRequest& request);

inline constexpr double kLeastPart = 8.0;

}  // namespace headland

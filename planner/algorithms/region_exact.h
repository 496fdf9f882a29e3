// The shortest plan, by dynamic programming.
#pragma once

#include "planner/region_plan.h"

namespace headland {

// Held and Karp, 'A dynamic programming approach to sequencing problems', 1962, over the set of
// parts visited, the last of them and its variant: 2^N S lengths for S variants of all parts, about
// 2^N S^2 / 4 steps. With four variants 12 parts take milliseconds, 18 a second and 150 MB, 20
// 670 MB. Cannot end early but by cancelling: limits of the search are not looked at. Nothing is
// random. Throws InputError as begun_search, for more than kMostExactBytes; Cancelled.
RegionPlan plan_region_exact(const RegionRequest& request);

inline constexpr double kMostExactBytes = 1024.0 * 1024.0 * 1024.0;

// What it would take.
double exact_plan_bytes(const RegionProblem& problem);

}  // namespace headland

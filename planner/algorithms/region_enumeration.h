// Every order of the parts in every combination of variants.
#pragma once

#include "planner/region_plan.h"

namespace headland {

// What 'IGA-CPP' takes its optimal lengths from: all N! orders with all variants, each counted as
// an evaluation. Ends at `evaluations` or `seconds` with the best so far; iterations and stagnation
// are no limits. Nothing is random. Throws InputError as begun_search, for more than
// kMostEnumerated plans; Cancelled.
RegionPlan plan_region_enumeration(const RegionRequest& request);

inline constexpr double kMostEnumerated = 2e10;

}  // namespace headland

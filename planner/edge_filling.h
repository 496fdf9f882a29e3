// Passes along edges without headland, where swaths are cut back before they reach over them.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "planner/headland_ground.h"
#include "planner/plan.h"
#include "planner/swaths.h"

namespace headland {

// Ground within a working width of edges without headland that neither rounds nor the swaths of
// `grids` work gets straight passes of its own (fill_passes), in an order with little driving
// between; patches of less than kLeastBesideEdge working widths squared are left. None for vehicles
// that only drive forwards, which do not get out of the corners where such passes end. Appended
// between rounds of the boundary and swaths, which `append_swaths` appends. Throws Cancelled.
void append_swaths_and_beside(const PlanRequest& request, const Headland& headland,
                              std::span<const SwathGrid> grids,
                              const std::function<void(std::vector<Pass>&)>& append_swaths,
                              std::vector<Pass>& passes);
inline constexpr double kLeastBesideEdge = 0.5;

}  // namespace headland

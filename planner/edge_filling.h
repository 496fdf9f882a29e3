// Passes along edges without headland, where swaths are cut back before they reach over them.
#pragma once

#include <span>
#include <vector>

#include "planner/headland_ground.h"
#include "planner/plan.h"
#include "planner/swaths.h"

namespace headland {

// A swath that is cut off square before an edge that crosses it at 45 degrees leaves half a working
// width squared. Smaller patches are not worth a pass's turns.
inline constexpr double kLeastBesideEdge = 0.5;

// Ground within a working width of edges without headland that neither rounds nor the swaths of
// `grids` work gets straight passes of its own (fill_passes), appended in an order with little
// driving between; patches of less than kLeastBesideEdge working widths squared are left. None for
// vehicles that only drive forwards, which do not get out of the corners where such passes end.
// Throws Cancelled.
void append_passes_beside(const PlanRequest& request, const Headland& headland,
                          std::span<const SwathGrid> grids, std::vector<Pass>& passes);

}  // namespace headland

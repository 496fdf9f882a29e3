// grid_plan.json: a plan on a grid map on disk, and what of it cannot be driven.
#pragma once

#include <string>

#include "planner/grid_drivable.h"

namespace headland {

// Counts and costs of the plan, its cells in order as `column row, ...`, and the cells that the
// implement does not wholly come to with the reason.
std::string grid_plan_json(const GridMap& map, const GridPlan& plan, const GridDrive& drive);

}  // namespace headland

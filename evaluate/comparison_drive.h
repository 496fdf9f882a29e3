// Plans of a comparison driven in physics.
#pragma once

#include <vector>

#include "evaluate/comparison.h"

namespace headland {

// What each map is driven on, in the comparison's order: the field that the map was made of, else
// the map's own (field_of_grid) with ground around it to turn on. Throws InputError as
// read_terrain, read_soil and load_vehicle do.
std::vector<Stage> drive_stages(const Comparison& comparison);

// Drives the best plan (best_run) of every planner on every map as comparison.drive says, which is
// given, on the maps' `stages`. Plans with jumps are not driven, nor what cannot be made drivable.
// The same results with any number of jobs. What an early end leaves is without `driven`.
void drive_best_plans(const Comparison& comparison, const std::vector<Stage>& stages,
                      const ParallelOptions& options, std::vector<ComparedRun>& runs);

}  // namespace headland

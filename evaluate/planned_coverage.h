// What a plan's path works of its field, before anything drives it.
#pragma once

#include "evaluate/coverage.h"
#include "planner/path.h"
#include "terrains/field.h"
#include "vehicle_models/vehicle.h"

namespace headland {

// The implement's, straight across the vehicle at implement.x_B_m, where the path has it down; in
// cells of at most half the working width. Throws InputError as measure_coverage does.
CoverageFigures planned_coverage(const Field& field, const Vehicle& vehicle, const Path& path,
                                 double cell_m);

}  // namespace headland

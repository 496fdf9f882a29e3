// Of the plans that a planner on fields makes, the one whose path takes least by measured costs.
#pragma once

#include "planner/drivable_path.h"
#include "planner/path_energy.h"
#include "planner/planners.h"

namespace headland {

struct PlannedPath {
  Plan plan;
  Path path;
};

// `request` has measured costs. Where its parameters leave the direction's objective or the order
// of swaths to costs (`auto`), plans are made by costs and as they would be without any, in every
// combination, all of them are made drivable, and the one with the least predicted energy is
// returned: never more than what there is without costs. What is cut off swath ends or left out
// counts as if it were worked, so that nothing is saved by leaving ground. Plans without a drivable
// path are passed over as long as there is another. Throws as the planner and make_path.
PlannedPath least_energy_path(const PlannerEntry& planner, const PlanRequest& request,
                              const Vehicle& vehicle, const PathOptions& options);

// What it is chosen by [W h].
double chosen_by_wh(const PlannedPath& planned, const Heightfield* terrain, const DriveCost& cost);

}  // namespace headland

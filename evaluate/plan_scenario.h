// Plans what a scenario describes and makes the plan drivable.
#pragma once

#include <optional>

#include "evaluate/scenario.h"
#include "planner/cancel.h"
#include "planner/drivable_path.h"
#include "planner/grid_drivable.h"

namespace headland {

struct PlanResult {
  Plan plan;
  Path path;
  std::optional<GridPlan> grid_plan;  // of planners on grid maps
  std::optional<GridDrive> grid_drive;
};

// `stage` is the scenario's. Throws PlanInfeasible, InputError for what the planner refuses of its
// request, and Cancelled.
PlanResult plan_scenario(const Scenario& scenario, const Stage& stage,
                         const CancelAsked& cancelled = {});

}  // namespace headland

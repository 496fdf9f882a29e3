// Plans what a scenario describes and makes the plan drivable.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evaluate/scenario.h"
#include "planner/cancel.h"
#include "planner/drivable_path.h"
#include "planner/grid_drivable.h"
#include "planner/path_energy.h"
#include "terrains/input_error.h"

namespace headland {

struct PlanResult {
  Plan plan;
  Path path;
  std::optional<GridPlan> grid_plan;  // of planners on grid maps
  std::optional<GridDrive> grid_drive;
  std::optional<PredictedEnergy> predicted;  // where the scenario names measured costs
  std::vector<std::string> notes;            // on these
};

// `stage` is the scenario's. Throws PlanInfeasible, InputError for what the planner refuses of its
// request and as read_drive_cost, and Cancelled.
PlanResult plan_scenario(const Scenario& scenario, const Stage& stage,
                         const CancelAsked& cancelled = {});

// Throws as check_path_options, with where that stands in the scenario.
void check_path_keys(const Scenario& scenario, const Vehicle& vehicle);

// What a planner refuses of its request, with where that stands in the file `source`.
InputError as_in_scenario(const InputError& refused, const std::string& source,
                          const PlannerChoice& planner);

// Of a scenario with a planner on grid maps the plan alone, without its path. Throws likewise.
GridPlan plan_on_grid(const Scenario& scenario, const Stage& stage,
                      const CancelAsked& cancelled = {});

// What the path will take by the costs that the scenario names, if it does, and notes on them.
// Throws InputError as read_drive_cost.
void predict(const Scenario& scenario, const Stage& stage, PlanResult& result);

}  // namespace headland

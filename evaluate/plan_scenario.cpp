#include "evaluate/plan_scenario.h"

#include "planner/grid_planners.h"
#include "planner/planners.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

// What a planner refuses of its request stands in the scenario.
Plan planned(const Scenario& scenario, const Stage& stage, const CancelAsked& cancelled) {
  const std::string source = scenario.file.string();
  PlanRequest request = plan_request(scenario, stage);
  request.cancelled = cancelled;
  try {
    return find_planner(scenario.planner.name, source).plan(request);
  } catch (const InputError& refused) {
    if (refused.where != "working_width_m") throw;
    throw InputError(source, "implement.working_width_m", refused.value, refused.allowed);
  }
}

// Likewise on a grid map.
GridPlan planned_on_grid(const Scenario& scenario, const Stage& stage,
                         const CancelAsked& cancelled) {
  const std::string source = scenario.file.string();
  GridPlanRequest request = grid_plan_request(scenario, stage);
  request.cancelled = cancelled;
  try {
    return find_grid_planner(scenario.planner.name, source).plan(request);
  } catch (const InputError& refused) {
    throw InputError(source, "planner: " + refused.where, refused.value, refused.allowed);
  }
}

}  // namespace

PlanResult plan_scenario(const Scenario& scenario, const Stage& stage,
                         const CancelAsked& cancelled) {
  PlanResult made;
  if (!stage.grid) {
    made.plan = planned(scenario, stage, cancelled);
    made.path = make_path(stage.field, stage.vehicle, made.plan, scenario.path, cancelled);
    return made;
  }
  made.grid_plan = planned_on_grid(scenario, stage, cancelled);
  made.grid_drive = make_grid_path(stage.field, stage.vehicle, *stage.grid, *made.grid_plan,
                                   scenario.path, cancelled);
  made.plan = made.grid_drive->plan;
  made.path = made.grid_drive->path;
  return made;
}

}  // namespace headland

#include "evaluate/plan_scenario.h"

#include <utility>

#include "evaluate/planner_cost.h"
#include "planner/grid_planners.h"
#include "planner/least_energy_path.h"
#include "planner/perturbed_plan.h"
#include "planner/planners.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

// What a planner refuses of its request stands in the scenario.
PlannedPath planned(const Scenario& scenario, const Stage& stage,
                    const std::optional<DriveCost>& cost, const CancelAsked& cancelled) {
  const std::string source = scenario.file.string();
  PlanRequest request = plan_request(scenario, stage);
  if (cost) request.cost = &*cost;
  request.cancelled = cancelled;
  const PlannerEntry& planner = find_planner(scenario.planner.name, source);
  try {
    if (cost) return least_energy_path(planner, request, stage.vehicle, scenario.path);
    PlannedPath made{planner.plan(request), {}};
    made.path = make_path(stage.field, stage.vehicle, made.plan, scenario.path, cancelled);
    return made;
  } catch (const InputError& refused) {
    throw as_in_scenario(refused, source, scenario.planner);
  }
}

// Likewise on a grid map.
GridPlan planned_on_grid(const Scenario& scenario, const Stage& stage,
                         const std::optional<DriveCost>& cost, const CancelAsked& cancelled) {
  const std::string source = scenario.file.string();
  GridPlanRequest request = grid_plan_request(scenario, stage);
  request.cost.measured = cost;
  request.cancelled = cancelled;
  try {
    const GridPlan plan = find_grid_planner(scenario.planner.name, source).plan(request);
    return perturbed_plan(request, plan, scenario.planner.grid->perturb);
  } catch (const InputError& refused) {
    throw InputError(source, "planner: " + refused.where, refused.value, refused.allowed);
  }
}

// Results outlive the files that their scenarios name, so that only who plans looks for them.
std::optional<DriveCost> read_if_given(const std::filesystem::path& file, const std::string& place,
                                       const Scenario& scenario, const Stage& stage,
                                       std::vector<std::string>& notes) {
  if (file.empty()) return std::nullopt;
  if (!place.empty() && !std::filesystem::exists(file)) {
    throw InputError(scenario.file.string(), place, file.string(), "no such file");
  }
  return read_drive_cost(file, stage.vehicle, soil_text(scenario.soil), notes);
}

void predict_by(const Scenario& scenario, std::optional<DriveCost> cost, const Stage& stage,
                PlanResult& result) {
  if (!scenario.planner.predict_file.empty()) {
    cost = read_if_given(scenario.planner.predict_file, scenario.planner.predict_place, scenario,
                         stage, result.notes);
  }
  if (cost) result.predicted = predicted_energy(result.path, &stage.terrain, *cost);
}

}  // namespace

InputError as_in_scenario(const InputError& refused, const std::string& source,
                          const PlannerChoice& planner) {
  if (refused.where == "working_width_m") {
    return {source, "implement.working_width_m", refused.value, refused.allowed};
  }
  if (refused.source != "plan") return refused;
  if (refused.where.starts_with("vehicle_")) {
    return {source, "vehicle", refused.where + " " + refused.value, refused.allowed};
  }
  return {source, place_of(planner, refused.where), refused.value, refused.allowed};
}

void check_path_keys(const Scenario& scenario, const Vehicle& vehicle) {
  try {
    check_path_options(vehicle, scenario.path);
  } catch (const InputError& refused) {
    throw InputError(scenario.file.string(),
                     scenario.continuous_turns_place.empty() ? "path." + refused.where
                                                             : scenario.continuous_turns_place,
                     refused.value, refused.allowed);
  }
}

GridPlan plan_on_grid(const Scenario& scenario, const Stage& stage, const CancelAsked& cancelled) {
  std::vector<std::string> notes;
  return planned_on_grid(scenario, stage,
                         read_if_given(scenario.planner.cost_file, scenario.planner.cost_place,
                                       scenario, stage, notes),
                         cancelled);
}

PlanResult plan_scenario(const Scenario& scenario, const Stage& stage,
                         const CancelAsked& cancelled) {
  check_path_keys(scenario, stage.vehicle);
  PlanResult made;
  const std::optional<DriveCost> cost = read_if_given(
      scenario.planner.cost_file, scenario.planner.cost_place, scenario, stage, made.notes);
  if (stage.grid) {
    made.grid_plan = planned_on_grid(scenario, stage, cost, cancelled);
    made.grid_drive = make_grid_path(stage.field, stage.vehicle, *stage.grid, *made.grid_plan,
                                     scenario.path, cancelled);
    made.plan = made.grid_drive->plan;
    made.path = made.grid_drive->path;
  } else {
    PlannedPath best = planned(scenario, stage, cost, cancelled);
    made.plan = std::move(best.plan);
    made.path = std::move(best.path);
  }
  predict_by(scenario, cost, stage, made);
  return made;
}

void predict(const Scenario& scenario, const Stage& stage, PlanResult& result) {
  predict_by(scenario,
             read_if_given(scenario.planner.cost_file, scenario.planner.cost_place, scenario, stage,
                           result.notes),
             stage, result);
}

}  // namespace headland

#include "evaluate/comparison_drive.h"

#include "evaluate/coverage.h"
#include "evaluate/parallel_runs.h"
#include "planner/grid_drivable.h"
#include "sim/simulation.h"
#include "terrains/grid_field.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

// What a map is driven on.
Stage stage_of(const Comparison& comparison, const ComparedMap& map) {
  const Scenario& scenario = *comparison.drive;
  const std::string source = comparison.file.string();
  Stage stage;
  stage.vehicle = vehicle_of(scenario, source);
  stage.field = map.field ? *map.field
                          : field_of_grid(map.map, grid_margin_m(stage.vehicle, scenario.path),
                                          source + ": drive");
  stage.field.name = map.name;
  stage.terrain = read_terrain(scenario.terrain, stage.field, source);
  stage.soil = read_soil(scenario.soil, stage.field, source).map;
  check_coverage_size(stage.field, scenario.working_width_m, scenario.coverage_cell_m, source);
  return stage;
}

// nullopt when it was cancelled.
std::optional<DrivenPlan> driven_plan(const Scenario& scenario, const Stage& stage,
                                      const GridMap& map, const GridPlan& plan,
                                      const CancelAsked& cancelled) {
  DrivenPlan driven;
  if (plan.jumps > 0) {
    driven.refusal = "the plan jumps between cells that are no neighbours";
    return driven;
  }
  try {
    const Path path =
        make_grid_path(stage.field, stage.vehicle, map, plan, scenario.path, cancelled).path;
    const RunRecord run =
        simulate({stage.field, stage.terrain, stage.soil, stage.vehicle, path, scenario.simulation,
                  [&](const SimulationProgress&) { return !cancelled(); }});
    if (run.outcome == Outcome::kInterrupted) return std::nullopt;
    driven.outcome = run.outcome;
    driven.outcome_detail = run.outcome_detail;
    driven.metrics = measure_run(
        path, run,
        coverage_figures(measure_coverage(stage.field, run.footprints, scenario.working_width_m,
                                          scenario.coverage_cell_m)));
    driven.verdict = judge(path, run, driven.metrics, scenario.verdict).grade;
  } catch (const PlanInfeasible& refused) {
    driven.refusal = refused.what();
  } catch (const InputError& refused) {
    driven.refusal = refused.what();
  } catch (const Cancelled&) {
    return std::nullopt;
  }
  return driven;
}

}  // namespace

std::vector<Stage> drive_stages(const Comparison& comparison) {
  std::vector<Stage> stages;
  stages.reserve(comparison.maps.size());
  for (const ComparedMap& map : comparison.maps) stages.push_back(stage_of(comparison, map));
  return stages;
}

void drive_best_plans(const Comparison& comparison, const std::vector<Stage>& stages,
                      const ParallelOptions& options, std::vector<ComparedRun>& runs) {
  std::vector<ComparedRun*> best;
  for (int m = 0; m < static_cast<int>(comparison.maps.size()); ++m) {
    for (int p = 0; p < static_cast<int>(comparison.planners.size()); ++p) {
      if (const ComparedRun* run = best_run(runs_of(runs, m, p))) {
        best.push_back(&runs[static_cast<std::size_t>(run - runs.data())]);
      }
    }
  }
  run_in_parallel(best.size(), options, [&](std::size_t i, const CancelAsked& cancelled) {
    ComparedRun& run = *best[i];
    const auto map = static_cast<std::size_t>(run.map);
    run.driven =
        driven_plan(*comparison.drive, stages[map], comparison.maps[map].map, run.plan, cancelled);
    return run.driven.has_value();
  });
}

}  // namespace headland

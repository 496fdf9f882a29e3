#include <mutex>
#include <optional>

#include "evaluate/plan_scenario.h"
#include "evaluate/planner_cost.h"
#include "evaluate/tuning_run.h"
#include "terrains/input_error.h"

namespace headland {
namespace {

// The plan of a run of the sweep as a driven one is known, without energies; none where there is no
// plan, which the drive will tell.
std::optional<PlanRun> planned_alone(const Sweep& sweep, std::size_t place,
                                     const CancelAsked& cancelled) {
  try {
    const Scenario scenario = scenario_at(sweep, place);
    const GridPlan plan = plan_on_grid(scenario, load_stage(scenario), cancelled);
    const SweepCell cell = cell_at(sweep, place);
    PlanRun run;
    run.block = cell.field;
    run.method = cell.planner;
    run.place = place;
    run.counts = plan.counts;
    run.jumps = plan.jumps > 0;
    run.cell_m = scenario.field.grid_map.empty() ? scenario.working_width_m : scenario.field.cell_m;
    return run;
  } catch (const InputError&) {
    return std::nullopt;
  } catch (const PlanInfeasible&) {
    return std::nullopt;
  }
}

}  // namespace

void check_design(const Tuning& tuning, const TuneOptions& options) {
  const Scenario& any = tuning.training.scenarios.front();
  std::vector<std::string> notes;
  read_drive_cost(tuning.costs, vehicle_of(any, tuning.file.string()), "", notes);
  const Sweep sweep = sweep_by(tuning.training, "design", training_methods(tuning));
  std::vector<std::optional<PlanRun>> made(cell_count(sweep));
  ParallelOptions parallel;
  parallel.jobs = options.jobs;
  parallel.cancelled = options.cancelled;
  parallel.progress = [&](int done, int all) {
    if (options.progress) options.progress("training plans", done, all);
  };
  bool ended = false;
  std::mutex ending;
  run_in_parallel(made.size(), parallel, [&](std::size_t i, const CancelAsked& cancelled) {
    try {
      made[i] = planned_alone(sweep, i, cancelled);
      return true;
    } catch (const Cancelled&) {
      const std::scoped_lock lock(ending);
      ended = true;
      return false;
    }
  });
  if (ended || (options.cancelled && options.cancelled())) throw Cancelled{};
  std::vector<PlanRun> plans;
  for (const std::optional<PlanRun>& run : made) {
    if (run && !run->jumps) plans.push_back(*run);
  }
  if (plans.empty()) return;
  for (const GridObjective form : tuning.forms) {
    // What measured costs tell is known of paths alone; kinds of movement that no plan has are none
    // of its terms.
    if (form == GridObjective::kMeasured) continue;
    check_fittable(form, plans, tuning.file.string(), tuning.training_place);
  }
}

}  // namespace headland

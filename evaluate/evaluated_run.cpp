#include "evaluate/evaluated_run.h"

#include <chrono>

#include "evaluate/coverage.h"
#include "evaluate/plan_file.h"
#include "sim/simulation.h"
#include "terrains/input_error.h"
#include "terrains/track.h"

namespace headland {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begun) {
  return std::chrono::duration<double>(Clock::now() - begun).count();
}

PlanResult plan_or_path(const Scenario& scenario, const Stage& stage,
                        const CancelAsked& cancelled) {
  if (scenario.path_file.empty()) return plan_scenario(scenario, stage, cancelled);
  PlanResult given;
  given.path =
      is_path_file(scenario.path_file)
          ? read_path(scenario.path_file, stage.field)
          : make_drivable(stage.field, stage.vehicle, read_track(scenario.path_file, stage.field),
                          scenario.path_tolerance_m, scenario.path, nullptr, cancelled);
  predict(scenario, stage, given);
  return given;
}

// False when it was cancelled.
bool drive(const Scenario& scenario, const Stage& stage, const Path& path,
           const CancelAsked& cancelled, EvaluatedRun& run) {
  const RunRecord record =
      simulate({stage.field, stage.terrain, stage.soil, stage.vehicle, path, scenario.simulation,
                [&](const SimulationProgress&) { return !cancelled || !cancelled(); }});
  if (record.outcome == Outcome::kInterrupted) return false;
  const Metrics metrics = measure_run(
      path, record,
      coverage_figures(measure_coverage(stage.field, record.footprints, scenario.working_width_m,
                                        scenario.coverage_cell_m)));
  set_drive_figures(metrics, record, run.figures);
  run.outcome = record.outcome;
  run.outcome_detail = record.outcome_detail;
  run.verdict = judge(path, record, metrics, scenario.verdict).grade;
  return true;
}

}  // namespace

std::string_view run_end_name(RunEnd end) {
  switch (end) {
    case RunEnd::kDriven:
      return "driven";
    case RunEnd::kNoPlan:
      return "no plan";
    case RunEnd::kRefused:
      break;
  }
  return "refused";
}

std::optional<EvaluatedRun> evaluate_run(const Scenario& scenario, SharedPlan& plan,
                                         const CancelAsked& cancelled) {
  EvaluatedRun run;
  try {
    auto begun = Clock::now();
    const Stage stage = load_stage(scenario);
    if (!plan.made) {
      plan.made = plan_or_path(scenario, stage, cancelled);
      plan.seconds = seconds_since(begun);
    }
    set_plan_figures(*plan.made, run.figures);
    run.figures[run_figure_place(kPlanSeconds)] = plan.seconds;
    begun = Clock::now();
    if (!drive(scenario, stage, plan.made->path, cancelled, run)) return std::nullopt;
    run.figures[run_figure_place(kDriveSeconds)] = seconds_since(begun);
  } catch (const PlanInfeasible& refused) {
    run.end = RunEnd::kNoPlan;
    run.reason = refused.what();
  } catch (const InputError& refused) {
    run.end = RunEnd::kRefused;
    run.reason = refused.what();
  } catch (const Cancelled&) {
    return std::nullopt;
  }
  return run;
}

}  // namespace headland

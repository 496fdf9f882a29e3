// The stages of an evaluation, one function each. Every stage reads from the results folder what
// the stage before it wrote, so that one run in stages and one run at once give the same bytes.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "evaluate/metrics.h"
#include "evaluate/plan_scenario.h"
#include "evaluate/report_record.h"
#include "evaluate/scenario.h"
#include "evaluate/verdict.h"
#include "render/pictures.h"
#include "sim/run_record.h"
#include "sim/simulation.h"

namespace headland {

// What the stages share: a scenario, what it describes, and where the results go.
struct Job {
  Scenario scenario;
  Stage stage;
  std::filesystem::path folder;
};

struct DriveResult {
  Path path;
  RunRecord run;
  Metrics metrics;
  Verdict verdict;
  std::vector<std::string> notes;  // what the user should know besides
  nlohmann::ordered_json json;     // of metrics.json
};

// Plans the field and makes the plan drivable. Writes scenario.yaml, plan.geojson, path.geojson
// and, of planners on grid maps, grid_plan.json.
// Throws PlanInfeasible, and Interrupted after Ctrl-C: nothing is written then.
PlanResult plan_stage(const Job& job, const CancelAsked& cancelled = {});

// Takes the scenario's path_file instead of planning: a path that headland wrote as it is, anything
// else made drivable, and then tells what that took. Writes scenario.yaml and path.geojson. Throws
// InputError and PlanInfeasible naming the file, and Interrupted after Ctrl-C: nothing is written
// then.
std::optional<TrackReport> given_path_stage(const Job& job, const CancelAsked& cancelled = {});

// Copies the plan and path that `plan` wrote into folder `from` to the job's folder. Throws
// InputError as read_path does: nothing is written then.
void adopt_plan(const Job& job, const std::filesystem::path& from);

// Drives path.geojson in physics, measures and judges it. Writes scenario.yaml, run.csv,
// footprint.csv, segments.csv and metrics.json. Throws Interrupted when `progress` stopped it:
// nothing of the run is kept then.
DriveResult drive_stage(const Job& job,
                        const std::function<bool(const SimulationProgress&)>& progress);

// What the folder holds of the job's run, however damaged.
RecordedRun recorded_run(const Job& job);

// Draws field.png, view.png and energy.png of it, with the verdict when the record is whole; writes
// them together.
void draw_stage(const Job& job, const RecordedRun& recorded, const PictureSize& size);

}  // namespace headland

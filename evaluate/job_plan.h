// Plans a job: every field from gate to gate, the transits between them, one path.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "evaluate/job_spec.h"
#include "planner/cancel.h"
#include "planner/path.h"
#include "planner/plan.h"
#include "sim/run_record.h"

namespace headland {

// A stretch of the path: a field, or a transit. Times and energies are known once it was driven.
struct JobPart {
  bool transit = false;
  std::string name;  // of the field
  std::string from;  // of a transit: fields, "start", "end"
  std::string to;
  double area_m2 = 0.0;  // of the field
  int passes = 0;
  double length_m = 0.0;
  double expected_time_s = 0.0;   // at the driver's speeds (make_route)
  std::size_t first_segment = 0;  // of the path
  std::size_t segments = 0;
};

// `scenario` has the fields and roads as its one field, of which the fields are to be worked, and
// no path file yet; `stage` is what it describes.
struct JobPlan {
  Scenario scenario;
  Stage stage;
  Plan plan;  // the passes of all fields in their order
  Path path;
  std::vector<JobPart> parts;  // in the path's order
  double road_length_m = 0.0;  // of the roads used, as drawn
};

// Orders fields and gates by what is driven: planned passes, ways from gate to first and from last
// pass to gate as straight lines, roads. Throws InputError as job_ground and load_stage, and
// PlanInfeasible naming field or transit; Cancelled.
JobPlan plan_job(const JobSpec& job, const CancelAsked& cancelled = {});

// What each part took in a run of the job's path.
struct JobPartRun {
  double time_s = 0.0;
  double distance_m = 0.0;
  double battery_j = 0.0;
};
std::vector<JobPartRun> runs_of_parts(const JobPlan& job, const RunRecord& run);

// job.json: parts and totals; `runs` empty or one a part. Keys: docs/jobs.md.
nlohmann::ordered_json job_json(const JobPlan& job, const std::vector<JobPartRun>& runs,
                                const std::string& version);

}  // namespace headland
